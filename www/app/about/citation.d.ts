// CITATION.cff as the build hands it to the page.

declare module "*.cff" {
  interface Person {
    readonly "family-names": string;
    readonly "given-names": string;
  }

  /** A group of people goes by one name. */
  interface Group {
    readonly name: string;
  }

  /** The fields of the Citation File Format 1.2.0 that the page reads. */
  export interface Work {
    readonly type: string;
    readonly title: string;
    readonly authors: readonly (Person | Group)[];
    readonly journal?: string;
    readonly volume?: number;
    readonly start?: number;
    readonly end?: number;
    readonly year?: number;
    readonly doi?: string;
    readonly version?: string;
    readonly "date-released"?: string;
    readonly "repository-code"?: string;
    readonly url?: string;
  }

  interface Citation extends Work {
    readonly message: string;
    readonly abstract: string;
    readonly license: string | readonly string[];
    /** The paper. */
    readonly "preferred-citation": Work;
  }

  const citation: Citation;
  export default citation;
}
