package org.dfra.river.security.budget;

import java.io.IOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.TimeUnit;
import org.dfra.core.budget.ListenerPriority;
import org.dfra.core.budget.RadioThinning;
import org.dfra.core.host.PrivateFiles;

/**
 * What the processes of one computer together send and receive, and which readings they do not
 * send: a small file that all of them map into their memory. No process waits for another one, and
 * one that dies leaves nothing behind.
 *
 * <p>It has 64-bit numbers in the order of the processor: the bytes so far; the number of the last
 * step; the bytes then; the bits of the rate in bytes per second, as a double; and for each {@link
 * ListenerPriority} how many readings it gets one of.
 */
final class RadioFile {

  /** The time of a step, in which the rate is measured. */
  static final long STEP_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

  private static final VarHandle LONGS =
      MethodHandles.byteBufferViewVarHandle(long[].class, ByteOrder.nativeOrder());

  private static final int BYTES = 0;
  private static final int STEP = 8;
  private static final int BYTES_AT_STEP = 16;
  private static final int RATE = 24;
  private static final int ONE_IN = 32;
  private static final int SIZE = ONE_IN + 8 * ListenerPriority.values().length;

  /** After so many steps without any, the rate is measured from the beginning. */
  private static final long FORGOTTEN = 8;

  /** How much of the rate is that of the last step; what remains is older. */
  private static final double WEIGHT = 0.5;

  private final MappedByteBuffer memory;

  private RadioFile(MappedByteBuffer memory) {
    this.memory = memory;
  }

  /** Opens a file, or makes it. */
  static RadioFile open(Path file) throws IOException {
    PrivateFiles.makeFile(file);
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
      return new RadioFile(channel.map(FileChannel.MapMode.READ_WRITE, 0, SIZE));
    }
  }

  private long get(int at) {
    return (long) LONGS.getVolatile(memory, at);
  }

  private void set(int at, long value) {
    LONGS.setVolatile(memory, at, value);
  }

  /** The rate of all processes, in bytes per second. */
  double rate() {
    return Double.longBitsToDouble(get(RATE));
  }

  /** For listeners of each priority, by ordinal, the n of which every n-th reading is sent. */
  int[] oneIn() {
    int[] all = new int[ListenerPriority.values().length];
    for (int i = 0; i < all.length; i++) {
      all[i] = (int) Math.max(1, Math.min(RadioThinning.MOST, get(ONE_IN + 8 * i)));
    }
    return all;
  }

  /**
   * Adds what a process has sent and received. The first process in each step decides for all.
   *
   * @param bytes since its last call
   * @param max what the radio carries, in bytes per second
   * @param nanos a monotonic clock that all processes of the computer share, in nanoseconds
   */
  void add(long bytes, double max, long nanos) {
    long unused = (long) LONGS.getAndAdd(memory, BYTES, bytes);
    long step = Math.floorDiv(nanos, STEP_NANOS);
    long last = get(STEP);
    if (step == last || !LONGS.compareAndSet(memory, STEP, last, step)) {
      return;
    }
    long all = get(BYTES);
    long before = get(BYTES_AT_STEP);
    set(BYTES_AT_STEP, all);
    long steps = step - last;
    if (steps < 0 || steps > FORGOTTEN) { // the first process, or the first since a restart
      set(RATE, Double.doubleToLongBits(0));
      store(RadioThinning.none());
      return;
    }
    double now = (all - before) * 1e9 / (steps * STEP_NANOS);
    double rate = WEIGHT * now + (1 - WEIGHT) * rate();
    set(RATE, Double.doubleToLongBits(rate));
    store(RadioThinning.next(oneIn(), rate, max));
  }

  private void store(int[] oneIn) {
    for (int i = 0; i < oneIn.length; i++) {
      set(ONE_IN + 8 * i, oneIn[i]);
    }
  }
}
