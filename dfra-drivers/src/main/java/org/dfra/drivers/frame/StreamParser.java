package org.dfra.drivers.frame;

/**
 * Parses bytes, split anywhere, and passes the messages in them to a consumer. Confined to one
 * thread. Never throws, whatever the bytes; its buffer is bounded.
 */
public interface StreamParser {

  /**
   * Processes the next bytes of the stream.
   *
   * @param bytes holds them
   * @param offset index of the first
   * @param length how many
   */
  void feed(byte[] bytes, int offset, int length);

  /** Ends the stream; the next byte fed begins a new stream. */
  void finish();

  /** What has been received so far. */
  StreamCounts counts();
}
