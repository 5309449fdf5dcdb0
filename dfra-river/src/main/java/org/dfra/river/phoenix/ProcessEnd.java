package org.dfra.river.phoenix;

/**
 * How a process ended.
 *
 * @param how the rest of a sentence that begins with the group's name
 * @param isAskedFor whether somebody asked for an orderly end; the daemon itself does not do so by
 *     a signal
 */
record ProcessEnd(String how, boolean isAskedFor) {

  /** Of a virtual machine whose shutdown was begun by SIGTERM: 128 and the signal's number. */
  private static final int TERMINATED = 143;

  static ProcessEnd byItself(String how) {
    return new ProcessEnd(how, false);
  }

  static ProcessEnd of(int exitCode) {
    return new ProcessEnd("ended (exit code " + exitCode + ")", exitCode == TERMINATED);
  }
}
