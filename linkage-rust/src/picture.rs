//! The `PICTURE` constant, and the `PROGRAMS` of a mechanism that is drawn.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
use super::outline::Outline;
use linkage_compiler::ir::{
    DriveOn, GuideOn, GuideShape, JointShape, Picture, PointKind, WheelContact, WheelTurn,
};

/// The constants of a mechanism that has a picture; `programs` describes it for pages.
pub(super) fn items(outline: &Outline, picture: &Picture, programs: &str) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let picture = self::literal(outline, picture);
    quote! {
        impl #name<__p::f64> {
            /// What the vectors of the quantity `picture()` are: points, links, guides.
            pub const PICTURE: &'static #runtime::Picture = &#picture;
        }
        #runtime::if_report! {
            impl #name<__p::f64> {
                /// The programs as JavaScript, with which the page of a report computes: for `Report::programs`.
                pub const PROGRAMS: #runtime::Programs = #runtime::Programs { description: #programs };
            }
        }
    }
}

fn literal(outline: &Outline, picture: &Picture) -> TokenStream {
    let runtime = &outline.runtime;
    let dimension = literal::index(picture.dimension);
    let points = picture.points.iter().map(|point| {
        let name = &point.name;
        let kind = match point.kind {
            PointKind::Ground => quote!(Ground),
            PointKind::Joint => quote!(Joint),
            PointKind::Tip => quote!(Tip),
            PointKind::Loose => quote!(Loose),
            PointKind::Construction => quote!(Construction),
        };
        quote!(#runtime::PicturePoint { name: #name, kind: #runtime::PointKind::#kind })
    });
    let directions = &picture.directions;
    let links = picture.links.iter().map(|link| {
        let name = &link.name;
        let points = link.points.iter().map(|&point| literal::index(point));
        quote!(#runtime::PictureLink { name: #name, points: &[#(#points),*] })
    });
    let guides = picture.guides.iter().map(|guide| {
        let name = &guide.name;
        let [origin, direction, slider] =
            [guide.origin, guide.direction, guide.slider].map(literal::index);
        let on = match guide.on {
            GuideOn::Frame => quote!(Frame),
            GuideOn::Itself => quote!(Itself),
            GuideOn::Link(link) => {
                let link = literal::index(link);
                quote!(Link(#link))
            }
        };
        let shape = match guide.shape {
            GuideShape::Slot => quote!(Slot),
            GuideShape::Cylinder => quote!(Cylinder),
            GuideShape::Arc => quote!(Arc),
        };
        quote! {
            #runtime::Guide {
                name: #name, origin: #origin, direction: #direction, slider: #slider, on: #runtime::GuideOn::#on,
                shape: #runtime::GuideShape::#shape,
            }
        }
    });
    let axes = picture.axes.iter().map(|&(point, direction)| {
        let (point, direction) = (literal::index(point), literal::index(direction));
        quote!(#runtime::Axis { point: #point, direction: #direction })
    });
    let joints = picture.joints.iter().map(|joint| {
        let point = literal::index(joint.point);
        let shape = match joint.shape {
            JointShape::Pin => quote!(Pin),
            JointShape::Slide => quote!(Slide),
            JointShape::Ball => quote!(Ball),
            JointShape::Universal => quote!(Universal),
            JointShape::Cylindrical => quote!(Cylindrical),
        };
        quote!(#runtime::PictureJoint { point: #point, shape: #runtime::JointShape::#shape })
    });
    let gears = picture.gears.iter().map(|gear| {
        let [a, b] = gear.centres.map(literal::index);
        let [first, second] = gear.turns.map(|turn| {
            let turn = match turn {
                WheelTurn::End(point) => {
                    let point = literal::index(point);
                    quote!(End(#point))
                }
                WheelTurn::Direction(direction) => {
                    let direction = literal::index(direction);
                    quote!(Direction(#direction))
                }
                WheelTurn::Fixed => quote!(Fixed),
            };
            quote!(#runtime::WheelTurn::#turn)
        });
        let contact = match gear.contact {
            WheelContact::Teeth => quote!(Teeth),
            WheelContact::Belt => quote!(Belt),
            WheelContact::BySense => quote!(BySense),
        };
        let contact = quote!(#runtime::WheelContact::#contact);
        quote!(#runtime::Gear { centres: [#a, #b], turns: [#first, #second], contact: #contact })
    });
    let drives = picture.drives.iter().map(|drive| {
        let input = literal::index(drive.input);
        let on = match drive.on {
            DriveOn::Turn(points) => {
                let [a, b] = points.map(literal::index);
                quote!(Turn([#a, #b]))
            }
            DriveOn::Slide(guide) => {
                let guide = literal::index(guide);
                quote!(Slide(#guide))
            }
        };
        quote!(#runtime::Drive { input: #input, on: #runtime::DriveOn::#on })
    });
    let undrawn = picture.undrawn.iter().map(|&number| literal::index(number));
    let parts = picture.parts.iter().map(|part| {
        let name = &part.name;
        let [points, links, guides] = [&part.points, &part.links, &part.guides].map(|all| {
            let all = all.iter().map(|&index| literal::index(index));
            quote!(&[#(#all),*])
        });
        quote!(#runtime::PicturePart { name: #name, points: #points, links: #links, guides: #guides })
    });
    quote! {
        #runtime::Picture {
            dimension: #dimension,
            points: &[#(#points),*],
            directions: &[#(#directions),*],
            links: &[#(#links),*],
            guides: &[#(#guides),*],
            axes: &[#(#axes),*],
            joints: &[#(#joints),*],
            gears: &[#(#gears),*],
            drives: &[#(#drives),*],
            undrawn: &[#(#undrawn),*],
            parts: &[#(#parts),*],
        }
    }
}
