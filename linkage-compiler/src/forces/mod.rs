//! Forces: reactions of joints, driving torques, energies, as expressions of the same graph as the
//! motion.
//!
//! The method is virtual work on the bodies and joints that the user declares, not on the loops,
//! which may be written in any form. Every body has one joint to its parent, which makes a tree. A
//! joint of the tree carries the sum of all loads beyond it. Joints that close loops are cut, and
//! their reactions are found from the motions of the tree's joints, in which no work may be done
//! (see `system`). These are as many equations, in small groups, as an adjoint of the loops has.
//! The other reactions are sums.
//!
//! Files by floor, each of which uses files above it in this table only:
//!
//! | file | content |
//! |---|---|
//! | `tree` | the tree of bodies |
//! | `geometry` | origins, angles, axes as expressions, and the motions that joints allow |
//! | `positions` | the positions at which numbers are checked |
//! | `joint_motion`, `speeds`, `loading`, `wrench`, `body_loads`, `loop_values`, `system` | types |
//! | `multibody` | the bodies, and facts about them that numbers show |
//! | `context` | the bodies with the results that are known, and the question of a function |
//! | `names` | joints, bodies and elements as messages name them |
//! | `motion` | velocities and accelerations of points and bodies |
//! | `masses`, `inertia` | masses, and moments of inertia when a body turns |
//! | `fixed_pins` | inertia of bodies that turn about a pin on the frame |
//! | `springs` | springs and dampers on each body |
//! | `contacts` | joints with friction: surfaces, friction for a given contact force |
//! | `loads` | inertia, weight, loads, springs and friction on each body |
//! | `virtual_work` | work of loads per motion of an input |
//! | `freedom` | motions of the tree's joints that nothing drives |
//! | `cut_joints` | sides of cut joints |
//! | `links` | links that leave one number of a reaction open |
//! | `equations`, `drives`, `assemble` | the system for the reactions of the cut joints |
//! | `rank` | blocks of equations that do not determine their unknowns |
//! | `loop_matches` | arms and determinants that the loops' closed forms have already |
//! | `body_wrench`, `equilibrium` | wrenches beyond joints and the reactions of cut joints |
//! | `reactions` | reactions of all joints |
//! | `contact_forces` | contact forces that depend on the friction that they cause |
//! | `friction` | friction from the reactions that it changes |
//! | `dynamics` | mass matrix, bias, generalised forces, accelerations without drives |
//! | `driving` | torques, forces and power of drives |
//! | `losses` | power of friction, efficiency |
//! | `quantities` | the quantities that functions ask for |
//! | `ends`, `fit` | checks on numbers |
//! | `steady` | facts about the motion that only numbers show |
//! | `shared_angles` | bodies whose angles follow from one unknown, for messages |
//! | `print` | the order in which reactions are found, for golden files |
//! | `friction_check` | checks numbers of friction |
//! | `check` | checks whether forces can be found from the declarations |

mod assemble;
mod body_loads;
mod body_wrench;
mod check;
mod contact_forces;
mod contacts;
mod context;
mod cut_joints;
mod drives;
mod driving;
mod dynamics;
mod ends;
mod equations;
mod equilibrium;
mod fit;
mod fixed_pins;
mod freedom;
mod friction;
mod friction_check;
mod geometry;
mod inertia;
mod joint_motion;
mod links;
mod loading;
mod loads;
mod loop_matches;
mod loop_values;
mod losses;
mod masses;
mod motion;
mod multibody;
mod names;
mod positions;
mod print;
pub(crate) mod quantities;
mod rank;
mod reactions;
mod shared_angles;
mod speeds;
mod springs;
mod steady;
mod system;
mod tree;
mod virtual_work;
mod wrench;

pub(crate) use check::check;
pub(crate) use context::{Forces, Question};
pub(crate) use print::describe;
