package org.dfra.sim.device;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.Random;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * The cable between a computer and an emulated device, with injected faults. It works with either
 * transport, a {@link DeviceEmulator} or a {@link SimPort}, which owns it and the device.
 *
 * <p>One fault is active at a time; a new one replaces the last:
 *
 * <pre>
 *              unplug()                the link is lost and cannot be opened
 *   sound  --- mute()                  the link stays open, no bytes pass ----------.
 *     ^        corruptBytes(..)        some bytes are changed, in either direction  |
 *     |        injectNoiseBursts(..)   noise between the device's output            |
 *     '---------------------------- restore() --------------------------------------'
 * </pre>
 *
 * <p>Thread-safe; the owner sees a change at its next poll.
 */
public final class Cable {

  private static final int CHUNK = 4096;
  private static final UnaryOperator<byte[]> SOUND = UnaryOperator.identity();
  private static final UnaryOperator<byte[]> NOTHING = bytes -> new byte[0];

  @GuardedBy("this")
  private SerialDevice device;

  @GuardedBy("this")
  private boolean pulled;

  @GuardedBy("this")
  private UnaryOperator<byte[]> toDevice = SOUND;

  @GuardedBy("this")
  private UnaryOperator<byte[]> fromDevice = SOUND;

  // to the device; null until it was connected
  @GuardedBy("this")
  private @Nullable UartLine channel;

  // of the computer's port; 0: same as the device
  @GuardedBy("this")
  private int portBaud;

  // polls are frequent
  @GuardedBy("this")
  private final ByteBuffer chunk = ByteBuffer.allocate(CHUNK);

  Cable(SerialDevice device) {
    this.device = device;
  }

  /** Unplugs the cable: the computer loses its link and gets no other until {@link #restore}. */
  public synchronized void unplug() {
    set(true, NOTHING, NOTHING);
    channel = null; // bytes in transit
  }

  /** Blocks all bytes, as a device that hangs does. */
  public synchronized void mute() {
    set(false, NOTHING, NOTHING);
  }

  /**
   * Corrupts bytes: they are misread, lost, or preceded by spurious ones.
   *
   * @param seed the same corruption for the same bytes and seed
   * @param share of the bytes that are corrupted, 0 to 1
   */
  public synchronized void corruptBytes(long seed, double share) {
    set(false, new ByteCorrupter(seed, share)::corrupt, new ByteCorrupter(~seed, share)::corrupt);
  }

  /**
   * Injects bursts of up to 2000 random bytes between the device's output, which itself is not
   * corrupted. The computer's bytes pass unchanged.
   *
   * @param seed the same bursts for the same chunks and seed
   */
  public synchronized void injectNoiseBursts(long seed) {
    set(false, SOUND, new NoiseBurstInjector(seed)::withNoise);
  }

  /** Ends the fault. */
  public synchronized void restore() {
    set(false, SOUND, SOUND);
  }

  /**
   * Replaces the device: with another kind, or with the same one that was switched off and on and
   * has lost its settings. An open link stays open.
   *
   * @param next nothing else may use it from now on
   */
  public synchronized void replace(SerialDevice next) {
    device = next;
    channel = null;
  }

  @GuardedBy("this")
  private void set(boolean isPulled, UnaryOperator<byte[]> there, UnaryOperator<byte[]> back) {
    pulled = isPulled;
    toDevice = there;
    fromDevice = back;
  }

  /** Whether the cable is unplugged. */
  public synchronized boolean isPulled() {
    return pulled;
  }

  /** Current bits per second of the device's serial line; 0 without one. */
  synchronized int baud() {
    return device.baud();
  }

  /**
   * Sets the speed of the computer's port. While it differs from the device's, each side misreads
   * what the other sends.
   *
   * @param baud bits per second; 0 follows the device, the default
   */
  public synchronized void setPortBaud(int baud) {
    portBaud = baud;
  }

  /** Bits per second of the computer's port; 0 while it follows the device. */
  public synchronized int portBaud() {
    return portBaud;
  }

  /** A computer was connected; the speed of its port stays as set. */
  synchronized void connected() {
    device.connected();
  }

  /** The computer was disconnected. */
  synchronized void disconnected() {
    device.disconnected();
  }

  /** Whether output that the computer does not read at once is buffered. */
  synchronized boolean buffersOutput() {
    return device.buffersOutput();
  }

  /** Accepts bytes from the computer; they are in transit from {@code now} on. */
  synchronized void send(byte[] bytes, Instant now) {
    int baud = device.baud();
    if (pulled || bytes.length == 0) {
      return;
    }
    if (baud == 0) {
      receive(bytes, now);
      return;
    }
    UartLine used = channel == null ? new UartLine(baud) : channel;
    used.setBaud(portBaud == 0 ? baud : portBaud);
    used.send(bytes, now);
    channel = used;
  }

  /**
   * Delivers the bytes that have arrived by {@code now}: to the device those that the computer
   * sent; those for the computer are returned.
   */
  synchronized byte[] pass(Instant now) {
    if (channel != null) {
      channel.drainTo(chunk.clear(), now);
      receive(taken(chunk), now);
    }
    chunk.clear();
    int sentAt = device.baud();
    device.transmit(chunk, now);
    return fromDevice.apply(read(taken(chunk), sentAt, portBaud));
  }

  /** Bytes sent at one baud rate as read at another; 0 is the sender's rate. */
  private static byte[] read(byte[] bytes, int sentAt, int readAt) {
    return sentAt == 0 || readAt == 0 ? bytes : BaudMismatch.of(bytes, sentAt, readAt);
  }

  @GuardedBy("this")
  private void receive(byte[] bytes, Instant now) {
    byte[] through = toDevice.apply(read(bytes, portBaud, device.baud()));
    if (through.length > 0) {
      device.receive(through, 0, through.length, now);
    }
  }

  private static byte[] taken(ByteBuffer chunk) {
    byte[] bytes = new byte[chunk.position()];
    chunk.flip().get(bytes);
    return bytes;
  }

  /**
   * Inserts noise bursts between a device's output, as a serial line that floats at times. The
   * output itself is unchanged. Reproducible for the same chunks and seed; confined to one thread.
   */
  private static final class NoiseBurstInjector {

    private static final int LONGEST = 2000;

    /** One in this many chunks is preceded by noise. */
    private static final int ONE_OF = 3;

    private final Random random;

    NoiseBurstInjector(long seed) {
      this.random = new Random(seed);
    }

    /** A chunk, preceded by its noise burst if it has one. */
    byte[] withNoise(byte[] piece) {
      if (piece.length == 0 || random.nextInt(ONE_OF) != 0) {
        return piece;
      }
      byte[] noise = new byte[random.nextInt(LONGEST)];
      random.nextBytes(noise);
      return ByteBuffer.allocate(noise.length + piece.length).put(noise).put(piece).array();
    }
  }

  /** Corrupts bytes as a bad contact does; reproducible by its seed. Confined to one thread. */
  static final class ByteCorrupter {

    private final Random random;
    private final double share;

    /**
     * @param share of the bytes that are damaged, 0 to 1
     */
    ByteCorrupter(long seed, double share) {
      if (!(share >= 0 && share <= 1)) {
        throw new IllegalArgumentException("share " + share + " is outside 0 to 1");
      }
      this.random = new Random(seed);
      this.share = share;
    }

    /** The bytes after corruption, at most twice as many. */
    byte[] corrupt(byte[] bytes) {
      ByteBuffer out = ByteBuffer.allocate(2 * bytes.length);
      for (byte each : bytes) {
        if (random.nextDouble() >= share) {
          out.put(each);
          continue;
        }
        switch (random.nextInt(3)) {
          case 0 -> out.put((byte) random.nextInt()); // bits were misread
          case 1 -> out.put((byte) random.nextInt()).put(each); // a spike was read as a byte
          default -> {} // its start bit was missed
        }
      }
      byte[] garbled = new byte[out.position()];
      out.flip().get(garbled);
      return garbled;
    }
  }

  /**
   * Simulates a receiver with another baud rate than the sender's, bit by bit, 8N1: it waits for a
   * falling edge and samples in the middle of what it assumes to be each bit. Pure.
   */
  static final class BaudMismatch {

    private static final int BITS = 10;

    private BaudMismatch() {}

    /**
     * The bytes that the receiver reads.
     *
     * @param sent bytes on a line that was idle before and is idle after; without gaps
     * @param sentBaud bits per second of the sender
     * @param readBaud bits per second of the receiver
     */
    static byte[] of(byte[] sent, int sentBaud, int readBaud) {
      if (sentBaud == readBaud) {
        return sent;
      }
      ByteArrayOutputStream read = new ByteArrayOutputStream();
      double step = (double) sentBaud / readBaud; // sent bits in a bit that is read
      int end = sent.length * BITS;
      int fall = nextFall(sent, 0);
      while (fall < end) {
        int value = 0;
        for (int bit = 0; bit < 8; bit++) {
          value |= level(sent, fall + (1.5 + bit) * step) << bit;
        }
        if (level(sent, fall + 0.5 * step) == 0) { // else it was a spike, not a start bit
          read.write(value);
        }
        fall = nextFall(sent, (int) Math.ceil(fall + 9.5 * step));
      }
      return read.toByteArray();
    }

    /** The first bit from here on that is low after a high one. */
    private static int nextFall(byte[] sent, int from) {
      int end = sent.length * BITS;
      int at = from;
      while (at < end && (level(sent, at) != 0 || (at > 0 && level(sent, at - 1) == 0))) {
        at++;
      }
      return at;
    }

    /** The line at a time, in sent bits; idle is high. */
    private static int level(byte[] sent, double time) {
      int bit = (int) Math.floor(time);
      if (bit < 0 || bit >= sent.length * BITS) {
        return 1;
      }
      int place = bit % BITS;
      return place == 0 ? 0 : place == BITS - 1 ? 1 : sent[bit / BITS] >> (place - 1) & 1;
    }
  }
}
