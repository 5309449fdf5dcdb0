package org.dfra.drivers.laser.lms;

/** Is told what the laser says; on the reader thread. */
interface LmsListener {

  /** Something intact has come, or {@link LmsProtocol#PREPARED}; for those who wait for it. */
  void messageReceived(String name);

  /**
   * A scan that is understood.
   *
   * @param mode what of its samples is the distance
   * @param variant where its beams are
   * @param baud bits per second of the line that it came over
   */
  void scanReceived(LmsScan scan, MeasuringMode mode, LmsVariant variant, int baud);

  /** Every intact telegram. */
  void telegramReceived(LmsMessage.Telegram telegram);

  /** An intact telegram that cannot be believed. */
  void malformedReceived(String name, String reason);

  /** Something that a person should know, a sentence. */
  void warn(String sentence);

  /** There are no scans now, for this reason, a clause. */
  void scansLost(String reason);

  /** The laser answers, but no scan has come yet: what is awaited, a clause. */
  void awaiting(String what);

  /** Whether no scans are wanted now. */
  boolean isIdleRequested();
}
