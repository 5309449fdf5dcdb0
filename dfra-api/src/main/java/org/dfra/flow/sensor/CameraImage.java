package org.dfra.flow.sensor;

import java.time.Instant;
import java.util.Arrays;
import org.dfra.event.Reading;

/**
 * An image as its camera encoded it.
 *
 * <p>The camera is a pin hole: a point x forward, y left, z up in its frame is projected {@code
 * focalLength · y / x} pixels to the left of the image's middle and {@code focalLength · z / x}
 * above it.
 *
 * @param measured when it was taken, UTC
 * @param frame name of the camera's frame, which looks along its x, e.g. {@code atrv1/camera}
 * @param band its spectral band
 * @param width pixels
 * @param height pixels
 * @param focalLength pixels
 * @param mediaType how the data is encoded: {@code image/jpeg}, or {@code image/png}; a thermal
 *     image in 16-bit grey levels of 0.01 K
 * @param data the encoded image. Copied in and out.
 */
public record CameraImage(
    Instant measured,
    String frame,
    Band band,
    int width,
    int height,
    double focalLength,
    String mediaType,
    @SuppressWarnings("ArrayRecordComponent") byte[] data)
    implements Reading {

  /** The spectral band of a camera. */
  public enum Band {
    /** Visible light. */
    VISIBLE,
    /** Thermal infrared. */
    THERMAL
  }

  public CameraImage {
    if (frame.isBlank()) {
      throw new IllegalArgumentException("an image names no frame");
    }
    if (width < 1 || height < 1 || !(focalLength > 0)) {
      throw new IllegalArgumentException(
          "an image of " + width + " × " + height + " pixels, focal length " + focalLength);
    }
    data = data.clone();
  }

  @Override
  public byte[] data() {
    return data.clone();
  }

  /** Bytes of the encoded image. */
  public int size() {
    return data.length;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof CameraImage that
        && measured.equals(that.measured)
        && frame.equals(that.frame)
        && band == that.band
        && width == that.width
        && height == that.height
        && focalLength == that.focalLength
        && mediaType.equals(that.mediaType)
        && Arrays.equals(data, that.data);
  }

  @Override
  public int hashCode() {
    return 31 * measured.hashCode() + Arrays.hashCode(data);
  }

  /** One line with the number of bytes instead of the bytes. */
  @Override
  public String toString() {
    return "CameraImage[measured="
        + measured
        + ", frame="
        + frame
        + ", band="
        + band
        + ", "
        + width
        + " × "
        + height
        + ", "
        + mediaType
        + ", "
        + data.length
        + " bytes]";
  }
}
