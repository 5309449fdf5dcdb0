package org.dfra.drivers.frame;

/**
 * Counts of what has been received from a device.
 *
 * @param frames intact frames
 * @param droppedBytes bytes that belong to no frame
 * @param malformed intact frames with invalid values; included in the frames
 */
public record StreamCounts(long frames, long droppedBytes, long malformed) {

  /** Nothing yet. */
  public static final StreamCounts ZERO = new StreamCounts(0, 0, 0);
}
