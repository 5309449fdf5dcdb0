package org.dfra.drivers.laser.lms;

/** Receives what the laser reports; on the reader thread. */
interface LmsListener {

  /**
   * An intact message has been received, or {@link LmsProtocol#PREPARED}; for threads that wait for
   * it.
   */
  void messageReceived(String name);

  /**
   * A scan that can be interpreted.
   *
   * @param mode measuring mode, which defines the distance bits of a sample
   * @param variant its field of view and resolution
   * @param baud bits per second of its link
   */
  void scanReceived(LmsScan scan, MeasuringMode mode, LmsVariant variant, int baud);

  /** Every intact telegram. */
  void telegramReceived(LmsMessage.Telegram telegram);

  /** An intact telegram with an invalid value. */
  void malformedReceived(String name, String reason);

  /** A warning for the operator, as a sentence. */
  void warn(String sentence);

  /** No scans are received, for this reason, a clause. */
  void scansLost(String reason);

  /** The laser answers, but no scan has been received yet: what is missing, a clause. */
  void awaiting(String what);

  /** Whether no scans are required now. */
  boolean isIdleRequested();
}
