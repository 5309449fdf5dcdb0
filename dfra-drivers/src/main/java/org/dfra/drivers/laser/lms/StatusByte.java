package org.dfra.drivers.laser.lms;

/**
 * The last byte of every reply: the laser's status.
 *
 * @param bits 7 the front window is dirty, 6 the measured values are not plausible, 5 it has been
 *     restarted, 4 and 3 its family, 2 to 0 the severity; 10 hex is a healthy LMS 200
 */
record StatusByte(int bits) {

  /** A healthy LMS 200. */
  public static final StatusByte OK = new StatusByte(0x10);

  /** Severity of an error. */
  public enum Severity {
    /** No error. */
    NONE,
    /** Information. */
    INFO,
    /** It still measures. */
    WARNING,
    /** It may not measure. */
    ERROR,
    /** It no longer measures. */
    FATAL,
    /** A value that is not in the telegram listing. */
    UNKNOWN
  }

  /** Severity of the worst error. */
  public Severity severity() {
    return Severity.values()[Math.min(bits & 7, Severity.UNKNOWN.ordinal())];
  }

  /** Whether its front window is dirty. */
  public boolean isPolluted() {
    return (bits & 0x80) != 0;
  }

  /** Whether its measured values contradict each other. */
  public boolean isImplausible() {
    return (bits & 0x40) != 0;
  }

  /** Whether it is healthy: no warning or error, window clean, values plausible. */
  public boolean isSound() {
    return severity().compareTo(Severity.WARNING) < 0 && !isPolluted() && !isImplausible();
  }

  /** {@code severity NONE}, {@code severity ERROR, window dirty}. */
  public String inWords() {
    return "severity "
        + severity()
        + (isPolluted() ? ", window dirty" : "")
        + (isImplausible() ? ", values not plausible" : "");
  }
}
