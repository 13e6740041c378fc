/** A number of a result. */
export interface Column { readonly name: string; readonly unit: string }

/** Three components. */
export type Axis = [number, number, number];

/** What is found in the range of an input. */
export interface RangeFinding {
  /**
   * At a change point two assemblies meet, and the mechanism may go on in either. Beyond a dead point it does not close; a gap ends at `to`.
   * Something is undefined where it is no finite number.
   */
  readonly kind: "change point" | "dead point" | "gap" | "undefined";
  /** The group, from 0. */
  readonly group: number;
  readonly from: number;
  readonly to: number;
  /** By how much the group misses closing at worst. */
  readonly miss: number;
}

/** The check of a range: its findings in the order of the inputs. */
export interface RangeReport {
  /** The input that runs through its range, the others being at their references; null if nothing is checked. */
  readonly input: string | null;
  readonly range: readonly [number, number] | null;
  readonly findings: readonly RangeFinding[];
  /** Why nothing is checked. */
  readonly unchecked: string | null;
}

/** A mechanism, with dimensions `D` and assemblies `A`. */
export interface Mechanism<D, A> {
  readonly name: string;
  readonly dimensions: readonly { readonly name: keyof D; readonly unit: string; readonly value: number; readonly tolerance: number }[];
  readonly inputs: readonly { readonly name: string; readonly unit: string; readonly reference: number; readonly range: readonly [number, number] | null }[];
  /** The assembly mode of each group that has two: 1 or -1. */
  readonly modes: readonly number[];
  readonly functions: readonly { readonly name: string; readonly arguments: readonly string[]; readonly columns: readonly Column[] }[];
  /**
   * Closes the loops at the reference inputs. Dimensions that are not given are as declared. Groups without a closed form are followed from the
   * assembly `from`, else from the declared one.
   *
   * @throws AssemblyError where they do not close
   */
  assemble(dimensions?: Partial<D>, options?: { modes?: readonly number[]; from?: A }): A;
  /** The dimensions that it was assembled with. */
  dimensionsOf(assembly: A): D;
  /**
   * Searches the declared range for places where the assembly ends, or may go on in another one; a turn where an angle, the only input, has no
   * range. Some thousand evaluations.
   */
  checkRange(assembly: A): RangeReport;
  /** By how much each group misses closing at these inputs: positive where it does. */
  gaps(assembly: A, ...inputs: number[]): Float64Array;
  /** The columns of a function over many positions: each argument a list, or a number that is the same at all positions. */
  columns(assembly: A, name: string, ...values: (number | ArrayLike<number>)[]): Float64Array[];
}

/** Why loops do not close. */
export declare class AssemblyError extends Error {
  readonly why: "open" | "undefined" | "lost" | "turns" | "dimension";
  /** Of `open` and `undefined`: the group, from 0. */
  readonly group?: number;
  /** Of `open`: by how much it misses closing. */
  readonly miss?: number;
  /** Of `dimension`: its place among all. */
  readonly dimension?: number;
}
