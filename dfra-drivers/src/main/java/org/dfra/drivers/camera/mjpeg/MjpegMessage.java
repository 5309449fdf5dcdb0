package org.dfra.drivers.camera.mjpeg;

/** What comes from the camera. */
public sealed interface MjpegMessage {

  /**
   * The response has begun.
   *
   * @param head its head
   */
  record Response(HttpHead head) implements MjpegMessage {}

  /**
   * An image, whole from its first marker to its last.
   *
   * @param head the part's head
   * @param shape what the image is
   * @param data the image as the camera encoded it; nobody else holds it
   */
  record Part(
      HttpHead head, ImageFormat shape, @SuppressWarnings("ArrayRecordComponent") byte[] data)
      implements MjpegMessage {}

  /**
   * A part that is no image, or not a whole one, or too large.
   *
   * @param reason what it is
   */
  record Malformed(String reason) implements MjpegMessage {}

  /**
   * Nothing that could be understood will follow.
   *
   * @param reason why, as a clause
   */
  record Ended(String reason) implements MjpegMessage {}
}
