package org.dfra.river.transport;

import java.nio.ByteBuffer;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;

/** Unused buffers of the size of a block, outside the heap, for connections that are in use. */
final class BlockBuffers {

  private static final int KEPT = 128; // 2 MiB

  private static final ConcurrentLinkedQueue<ByteBuffer> UNUSED = new ConcurrentLinkedQueue<>();
  private static final AtomicInteger COUNT = new AtomicInteger();

  private BlockBuffers() {}

  /** An empty buffer of {@link Block#BLOCK_BYTES}. */
  static ByteBuffer take() {
    ByteBuffer unused = UNUSED.poll();
    if (unused == null) {
      return ByteBuffer.allocateDirect(Block.BLOCK_BYTES);
    }
    COUNT.decrementAndGet();
    return unused.clear();
  }

  /** Returns a buffer that nobody uses any more. */
  static void giveBack(ByteBuffer buffer) {
    if (COUNT.incrementAndGet() <= KEPT) {
      UNUSED.add(buffer);
    } else {
      COUNT.decrementAndGet(); // the garbage collector frees it
    }
  }
}
