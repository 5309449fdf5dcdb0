package org.dfra.drivers.camera.mjpeg;

/** A message from the camera. */
sealed interface MjpegMessage {

  /**
   * The response has begun.
   *
   * @param head its head
   */
  record Response(HttpHeader head) implements MjpegMessage {}

  /**
   * An image, complete from its first marker to its last.
   *
   * @param head the part's head
   * @param shape the image's format
   * @param data the image as the camera encoded it; not shared
   */
  record Part(
      HttpHeader head, ImageFormat shape, @SuppressWarnings("ArrayRecordComponent") byte[] data)
      implements MjpegMessage {}

  /**
   * A part that is not an image, incomplete, or too large.
   *
   * @param reason what is wrong
   */
  record Malformed(String reason) implements MjpegMessage {}

  /**
   * Nothing that can be parsed will follow.
   *
   * @param reason why, as a clause
   */
  record Ended(String reason) implements MjpegMessage {}
}
