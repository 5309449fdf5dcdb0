package org.dfra.river.transport;

import java.nio.ByteBuffer;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;

/** Unused buffers for one record of TLS, encrypted or not. */
final class TlsBuffers {

  /** The longest record that JSSE sends or receives, in bytes, is 16 709. */
  private static final int BYTES = 17 * 1024;

  private static final int KEPT = 64; // 1 MiB

  private static final ConcurrentLinkedQueue<ByteBuffer> UNUSED = new ConcurrentLinkedQueue<>();
  private static final AtomicInteger COUNT = new AtomicInteger();

  private TlsBuffers() {}

  /** An empty buffer. On the heap, where JSSE encrypts without a copy. */
  static ByteBuffer take() {
    ByteBuffer unused = UNUSED.poll();
    if (unused == null) {
      return ByteBuffer.allocate(BYTES);
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
