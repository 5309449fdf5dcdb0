package org.dfra.drivers.frame;

/**
 * What has come from a device so far.
 *
 * @param frames intact frames
 * @param droppedBytes bytes that belonged to no frame
 * @param malformed intact frames with values that cannot be; they are among the frames
 */
public record StreamCounts(long frames, long droppedBytes, long malformed) {

  /** Nothing yet. */
  public static final StreamCounts ZERO = new StreamCounts(0, 0, 0);
}
