package org.dfra.river.transport;

import java.io.IOException;

/**
 * The unit in which both sides send: a header of four bytes (kind, and length in three bytes, most
 * significant first) and that many bytes.
 *
 * @param kind its kind
 * @param length number of bytes after the header, at most {@value #MAX_BYTES}
 */
record Block(Kind kind, int length) {

  /** The size of a header, in bytes. */
  static final int HEADER_BYTES = 4;

  /** The size of a whole block, in bytes. A receiver allocates no more for an unread message. */
  static final int BLOCK_BYTES = 16 * 1024;

  /** The largest length after the header, in bytes. */
  static final int MAX_BYTES = BLOCK_BYTES - HEADER_BYTES;

  private static final int LENGTH_BITS = 24;

  /** What a block means. */
  enum Kind {
    /** A part of a message; another follows. */
    PART,
    /** The last part of a message; may be empty. */
    END,
    /** Empty, from the client: no call follows soon, so the server need not wait for one. */
    PAUSE,
    /**
     * Empty, from the server, instead of a response: it closes the connection, and a request that
     * it has not answered was not executed.
     */
    CLOSING
  }

  /**
   * Decodes a header.
   *
   * @param header the four bytes as an integer, most significant first
   * @throws IOException if the peer may not send it
   */
  static Block decode(int header) throws IOException {
    int code = header >>> LENGTH_BITS;
    int length = header & ((1 << LENGTH_BITS) - 1);
    if (code >= Kind.values().length || length > MAX_BYTES) {
      throw new IOException(
          "no block begins with 0x" + Integer.toHexString(header) + "; the peer is no DFRA peer");
    }
    Kind kind = KINDS[code];
    if (length > 0 && (kind == Kind.PAUSE || kind == Kind.CLOSING)) {
      throw new IOException("a block " + kind + " has " + length + " bytes instead of none");
    }
    return new Block(kind, length);
  }

  private static final Kind[] KINDS = Kind.values();

  /** The header as an integer. */
  int encode() {
    return encode(kind, length);
  }

  static int encode(Kind kind, int length) {
    return kind.ordinal() << LENGTH_BITS | length;
  }
}
