package org.dfra.drivers.gps.m12;

/**
 * What has come from a receiver so far.
 *
 * @param frames intact frames
 * @param droppedBytes bytes that belonged to no frame
 * @param malformed intact frames with values that cannot be; they are among the frames
 */
public record M12Counts(long frames, long droppedBytes, long malformed) {

  static final M12Counts ZERO = new M12Counts(0, 0, 0);
}
