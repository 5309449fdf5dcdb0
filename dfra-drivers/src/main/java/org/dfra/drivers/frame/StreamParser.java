package org.dfra.drivers.frame;

/**
 * Takes bytes, cut anywhere, and gives whoever it was made for the messages in them. Confined to
 * one thread. Never throws, whatever the bytes, and never holds more of them than it says.
 */
public interface StreamParser {

  /**
   * Takes the next bytes of the stream.
   *
   * @param bytes holds them
   * @param offset index of the first
   * @param length how many
   */
  void feed(byte[] bytes, int offset, int length);

  /** No more bytes will follow what was fed; the next byte fed begins a new stream. */
  void finish();

  /** What has come so far. */
  StreamCounts counts();
}
