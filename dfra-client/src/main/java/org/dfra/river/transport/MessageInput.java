package org.dfra.river.transport;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;

/**
 * One message of the peer. It is read to its end and no further. Used by one thread.
 *
 * <p>The buffer belongs to the connection: what it contains after this message's end is the next
 * message's beginning.
 */
final class MessageInput extends InputStream {

  private final ByteBuffer received; // ready to be read from
  private final Source source;
  private int left; // bytes of the current block that were not read yet
  private boolean begun; // whether there is a current block, or was one
  private boolean last; // whether the current block is the message's last one
  private boolean closed;

  /** Receives bytes. */
  interface Source {

    /**
     * Waits for more bytes.
     *
     * @param buffer to append to, in the state in which it is written
     * @throws IOException at the connection's end, too
     */
    void receive(ByteBuffer buffer) throws IOException;

    /**
     * The peer closes the connection instead of sending a message.
     *
     * @return what the reader gets to see
     */
    IOException refused();

    /** The reader needs no more of the message, or has all of it. Called once or twice. */
    void closed();
  }

  /**
   * The message that begins with the next block.
   *
   * @param received what was received already, ready to be read from; may be empty
   */
  MessageInput(ByteBuffer received, Source source) {
    this.received = received;
    this.source = source;
  }

  @Override
  public int read() throws IOException {
    if (!hasMore()) {
      return -1;
    }
    int value = received.get() & 0xff;
    consumed(1);
    return value;
  }

  @Override
  public int read(byte[] bytes, int offset, int length) throws IOException {
    if (length == 0) {
      return 0;
    }
    if (!hasMore()) {
      return -1;
    }
    int count = Math.min(length, Math.min(left, received.remaining()));
    received.get(bytes, offset, count);
    consumed(count);
    return count;
  }

  /** After the last byte, the connection may serve another message: the reader need not close. */
  private void consumed(int count) {
    left -= count;
    if (last && left == 0) {
      source.closed();
    }
  }

  @Override
  public int available() {
    return closed ? 0 : Math.min(left, received.remaining());
  }

  /** Waits until a byte of the message can be read; false at its end. */
  private boolean hasMore() throws IOException {
    if (closed) {
      throw new IOException("the message was closed");
    }
    return advance();
  }

  private boolean advance() throws IOException {
    while (left == 0) {
      if (last) {
        return false;
      }
      awaitBytes(Block.HEADER_BYTES);
      Block next = Block.decode(received.getInt());
      switch (next.kind()) {
        case PART -> left = next.length();
        case END -> {
          left = next.length();
          last = true;
        }
        case CLOSING, PAUSE -> {
          if (begun || next.kind() == Block.Kind.PAUSE) {
            throw new IOException("the peer interrupted a message by " + next.kind());
          }
          throw source.refused();
        }
      }
      begun = true;
    }
    awaitBytes(1);
    return true;
  }

  private void awaitBytes(int count) throws IOException {
    while (received.remaining() < count) {
      received.compact();
      try {
        source.receive(received);
      } finally {
        received.flip();
      }
    }
  }

  /**
   * Waits until so many bytes can be read without waiting, or all of a shorter block.
   *
   * @param count at most {@link Block#MAX_BYTES}
   * @return the number of bytes that can, at least one; 0 at the end
   */
  int await(int count) throws IOException {
    if (!advance()) {
      return 0;
    }
    int wanted = Math.min(left, count);
    awaitBytes(wanted);
    return wanted;
  }

  /** Reads a number that {@link #await} has waited for, and lets it be read again. */
  long peekLong(int offset) {
    return received.getLong(received.position() + offset);
  }

  /** Whether no block follows that which is read. */
  boolean isInLastBlock() {
    return last;
  }

  /** Whether the whole message has been read. */
  boolean isAtEnd() {
    return last && left == 0;
  }

  /** Skips the rest of the message if it has been received. Returns whether it had. */
  boolean skipReceived() {
    if (!last || left > received.remaining()) {
      return false;
    }
    received.position(received.position() + left);
    left = 0;
    return true;
  }

  /**
   * Skips the rest of the message.
   *
   * @param maxBytes of the rest
   * @return false if the rest is longer
   */
  boolean skipRest(long maxBytes) throws IOException {
    long skipped = 0;
    while (!isAtEnd()) {
      if (skipped > maxBytes) {
        return false;
      }
      if (advance()) {
        int count = Math.min(left, received.remaining());
        received.position(received.position() + count);
        left -= count;
        skipped += count;
      }
    }
    return true;
  }

  /** Ends the use of the stream; the connection decides about the rest of the message. */
  @Override
  public void close() {
    if (!closed) {
      closed = true;
      source.closed();
    }
  }

  /** The failure of a connection that ended within a message. */
  static EOFException ended() {
    return new EOFException("the peer closed the connection");
  }
}
