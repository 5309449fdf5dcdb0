package org.dfra.directory;

/** How far away a module is, the nearest first. */
public enum Locality {
  /** In the asker's own virtual machine: a call is a method call. */
  SAME_VM,
  /** On the asker's machine: a call crosses no cable and no radio. */
  SAME_HOST,
  /** Anywhere else. */
  REMOTE
}
