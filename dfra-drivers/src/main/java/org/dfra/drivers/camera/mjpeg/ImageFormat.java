package org.dfra.drivers.camera.mjpeg;

import java.util.Optional;

/**
 * The format of an encoded image, read from its markers without decoding it.
 *
 * @param mediaType {@code image/jpeg} or {@code image/png}
 * @param width pixels
 * @param height pixels
 * @param bits bits per sample
 * @param isGrey whether a pixel is one sample
 */
record ImageFormat(String mediaType, int width, int height, int bits, boolean isGrey) {

  private static final int MOST_PIXELS = 16_384; // along one side
  private static final int MOST_PADDING = 16; // bytes that a camera may put behind an image
  private static final int SOI = 0xD8;
  private static final int EOI = 0xD9;
  private static final int SOS = 0xDA;
  private static final byte[] PNG_HEAD = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  private static final byte[] IHDR = {0, 0, 0, 13, 'I', 'H', 'D', 'R'};
  private static final byte[] IEND = {
    0, 0, 0, 0, 'I', 'E', 'N', 'D', (byte) 0xAE, 0x42, 0x60, (byte) 0x82
  };

  /** Reads an image's markers; empty where it is not a complete JPEG or PNG. */
  static Optional<ImageFormat> of(byte[] bytes, int offset, int length) {
    if (length > 4 && at(bytes, offset) == 0xFF && at(bytes, offset + 1) == SOI) {
      return ofJpeg(bytes, offset, offset + length);
    }
    int head = PNG_HEAD.length;
    boolean isPng =
        length >= head + IHDR.length + 17 + IEND.length
            && matches(PNG_HEAD, bytes, offset)
            && matches(IHDR, bytes, offset + head)
            && matches(IEND, bytes, offset + length - IEND.length);
    return isPng ? ofPng(bytes, offset + head + IHDR.length) : Optional.empty();
  }

  private static Optional<ImageFormat> ofPng(byte[] bytes, int at) {
    int colour = at(bytes, at + 9);
    return checked(
        new ImageFormat(
            "image/png",
            number(bytes, at, 4),
            number(bytes, at + 4, 4),
            at(bytes, at + 8),
            colour == 0));
  }

  private static Optional<ImageFormat> ofJpeg(byte[] bytes, int offset, int end) {
    int last = end;
    while (last > offset && end - last < MOST_PADDING && isPadding(bytes[last - 1])) {
      last--;
    }
    if (last - offset < 4 || at(bytes, last - 2) != 0xFF || at(bytes, last - 1) != EOI) {
      return Optional.empty();
    }
    int at = offset + 2;
    while (at + 9 < last) {
      int marker = at(bytes, at + 1);
      if (at(bytes, at) != 0xFF || marker == SOS) {
        return Optional.empty(); // no frame header before the data
      }
      if (marker == 0xFF) {
        at++; // a fill byte
        continue;
      }
      if (isFrame(marker)) {
        return checked(
            new ImageFormat(
                "image/jpeg",
                number(bytes, at + 7, 2),
                number(bytes, at + 5, 2),
                at(bytes, at + 4),
                at(bytes, at + 9) == 1));
      }
      at += 2 + Math.max(2, number(bytes, at + 2, 2));
    }
    return Optional.empty();
  }

  /** Whether the marker is SOF0 to SOF15, except DHT, JPG and DAC. */
  private static boolean isFrame(int marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
  }

  private static boolean isPadding(byte last) {
    return last == 0 || last == '\r' || last == '\n';
  }

  private static Optional<ImageFormat> checked(ImageFormat shape) {
    boolean isPossible =
        shape.width > 0
            && shape.height > 0
            && shape.width <= MOST_PIXELS
            && shape.height <= MOST_PIXELS;
    return isPossible ? Optional.of(shape) : Optional.empty();
  }

  private static boolean matches(byte[] expected, byte[] bytes, int at) {
    for (int i = 0; i < expected.length; i++) {
      if (bytes[at + i] != expected[i]) {
        return false;
      }
    }
    return true;
  }

  private static int number(byte[] bytes, int at, int count) {
    int number = 0;
    for (int i = 0; i < count; i++) {
      number = number << 8 | at(bytes, at + i);
    }
    return number;
  }

  private static int at(byte[] bytes, int index) {
    return bytes[index] & 0xFF;
  }
}
