package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * The cable between a computer and an emulated device, with injected faults. It works with either
 * transport, a {@link DeviceEmulator} or a {@link SimPort}, which owns it and the device.
 *
 * <p>One fault is active at a time; a new one replaces the last:
 *
 * <pre>
 *              pull()      the link is lost and cannot be opened
 *   sound  --- silence()   the link stays open, no bytes pass in either direction ------.
 *     ^        garble(..)  some bytes are corrupted, in either direction                |
 *     |        storm(..)   noise bursts between the device's output                     |
 *     '------------------------------- restore() ---------------------------------------'
 * </pre>
 *
 * <p>Thread-safe; the owner sees a change at its next poll.
 */
public final class Cable {

  private static final int CHUNK = 4096;
  private static final UnaryOperator<byte[]> SOUND = UnaryOperator.identity();
  private static final UnaryOperator<byte[]> NOTHING = bytes -> new byte[0];

  // all guarded by this
  private SerialDevice device;
  private boolean pulled;
  private UnaryOperator<byte[]> toDevice = SOUND;
  private UnaryOperator<byte[]> fromDevice = SOUND;
  private @Nullable UartLine channel; // to the device; null until it was connected
  private int portBaud; // of the computer's port; 0: same as the device
  private final ByteBuffer chunk = ByteBuffer.allocate(CHUNK); // polls are frequent

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
}
