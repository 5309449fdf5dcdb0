package org.dfra.river.transport;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;

/**
 * One message to the peer, in blocks. A message that fits into one block is sent in a single write
 * when it is closed. Used by one thread.
 */
final class MessageOutput extends OutputStream {

  private final ByteBuffer block;
  private final Sender sender;
  private boolean closed;
  private boolean isComplete;

  /** Sends whole blocks. */
  interface Sender {

    /**
     * Sends.
     *
     * @param isEnd whether it is the message's last block: then nobody writes into the buffer any
     *     more, and it may be sent later
     */
    void send(ByteBuffer block, boolean isEnd) throws IOException;
  }

  /**
   * A new message.
   *
   * @param block the buffer for its blocks; its contents are overwritten
   */
  MessageOutput(ByteBuffer block, Sender sender) {
    this.block = block;
    this.sender = sender;
    begin();
  }

  private void begin() {
    block.clear().position(Block.HEADER_BYTES);
  }

  @Override
  public void write(int b) throws IOException {
    makeRoom();
    block.put((byte) b);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    int at = offset;
    int left = length;
    while (left > 0) {
      makeRoom();
      int count = Math.min(left, block.remaining());
      block.put(bytes, at, count);
      at += count;
      left -= count;
    }
  }

  /** Sends a full block only when more bytes follow, so that a message never ends with none. */
  private void makeRoom() throws IOException {
    if (closed) {
      throw new IOException("the message is already complete");
    }
    if (!block.hasRemaining()) {
      send(Block.Kind.PART);
    }
  }

  private void send(Block.Kind kind) throws IOException {
    block.putInt(0, Block.encode(kind, block.position() - Block.HEADER_BYTES));
    block.flip();
    boolean isEnd = kind == Block.Kind.END;
    sender.send(block, isEnd);
    if (!isEnd) {
      begin();
    }
  }

  /** Whether the whole message was sent. */
  boolean isComplete() {
    return isComplete;
  }

  /** Does nothing: a message is sent when it is complete, or a block of it when that is full. */
  @Override
  public void flush() {}

  @Override
  public void close() throws IOException {
    if (!closed) {
      closed = true;
      send(Block.Kind.END);
      isComplete = true;
    }
  }
}
