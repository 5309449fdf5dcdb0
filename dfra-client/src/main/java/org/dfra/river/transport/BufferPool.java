package org.dfra.river.transport;

import java.nio.ByteBuffer;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;

/** Buffers of one size that nobody uses at the moment, for connections that are in use. */
final class BufferPool {

  /** For a block, outside the heap. At most 2 MiB are kept. */
  static final BufferPool BLOCKS =
      new BufferPool(() -> ByteBuffer.allocateDirect(Block.BLOCK_BYTES), 128);

  /** The longest record that JSSE sends or receives, in bytes, is 16 709. */
  private static final int RECORD_BYTES = 17 * 1024;

  /**
   * For a record of TLS, encrypted or not; on the heap, where JSSE encrypts without a copy. At most
   * 1 MiB is kept.
   */
  static final BufferPool RECORDS = new BufferPool(() -> ByteBuffer.allocate(RECORD_BYTES), 64);

  private final Supplier<ByteBuffer> source;
  private final int kept;
  private final ConcurrentLinkedQueue<ByteBuffer> unused = new ConcurrentLinkedQueue<>();
  private final AtomicInteger count = new AtomicInteger();

  /**
   * @param kept how many unused ones are kept at most
   */
  private BufferPool(Supplier<ByteBuffer> source, int kept) {
    this.source = source;
    this.kept = kept;
  }

  /** An empty buffer. */
  ByteBuffer take() {
    ByteBuffer buffer = unused.poll();
    if (buffer == null) {
      return source.get();
    }
    count.decrementAndGet();
    return buffer.clear();
  }

  /** Returns a buffer that nobody uses any more. */
  void giveBack(ByteBuffer buffer) {
    if (count.incrementAndGet() <= kept) {
      unused.add(buffer);
    } else {
      count.decrementAndGet(); // the garbage collector frees it
    }
  }
}
