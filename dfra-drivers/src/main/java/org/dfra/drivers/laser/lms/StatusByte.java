package org.dfra.drivers.laser.lms;

/**
 * The last byte of every reply: how the laser is.
 *
 * @param bits 7 the front window is dirty, 6 the measured values are not plausible, 5 it has been
 *     restarted, 4 and 3 its family, 2 to 0 the severity; 10 hex is a sound LMS 200
 */
public record StatusByte(int bits) {

  /** A sound LMS 200. */
  public static final StatusByte OK = new StatusByte(0x10);

  /** How bad it is. */
  public enum Severity {
    /** All is well. */
    NONE,
    /** There is something to be known. */
    INFO,
    /** It measures on. */
    WARNING,
    /** It may not measure. */
    ERROR,
    /** It does not measure any more. */
    FATAL,
    /** A value that the telegram listing does not have. */
    UNKNOWN
  }

  /** How bad the worst error is. */
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

  /** Whether it can be used without a thought. */
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
