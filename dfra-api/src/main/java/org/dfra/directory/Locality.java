package org.dfra.directory;

/** The network distance of a module, the nearest first. */
public enum Locality {
  /** In the caller's virtual machine: a call is a method call. */
  SAME_VM,
  /** On the caller's machine: a call crosses no cable and no radio link. */
  SAME_HOST,
  /** Anywhere else. */
  REMOTE
}
