package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * The cable between a computer and an emulated device, and everything that can be wrong with it. It
 * is the same whatever carries the bytes, a {@link DeviceEmulator} or a {@link SimPort}, which owns
 * it and the device.
 *
 * <p>Of the faults there is one at a time; each takes the place of the last:
 *
 * <pre>
 *              pull()      the link is lost, and cannot be opened
 *   sound  --- silence()   the link stays, nothing comes through in either direction ---.
 *     ^        garble(..)  of what comes through in either direction some is damaged    |
 *     |        storm(..)   there is noise between what comes from the device            |
 *     '------------------------------- restore() ---------------------------------------'
 * </pre>
 *
 * <p>Safe for use by several threads; what is done here, the owner notices when it looks next.
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
  private @Nullable UartLine channel; // to the device; null until it has been on a line
  private int portBaud; // of the computer's port; 0 where that follows the device
  private final ByteBuffer chunk = ByteBuffer.allocate(CHUNK); // looks are many

  Cable(SerialDevice device) {
    this.device = device;
  }

  /** Pulls it out: the computer loses its link and gets no other until it is restored. */
  public synchronized void unplug() {
    set(true, NOTHING, NOTHING);
    channel = null; // what was on it
  }

  /** Has nothing come through, as from a device that hangs. */
  public synchronized void mute() {
    set(false, NOTHING, NOTHING);
  }

  /**
   * Damages bytes: they are misread, lost, or have others before them.
   *
   * @param seed the same damage for the same bytes and seed
   * @param share of the bytes that are damaged, 0 to 1
   */
  public synchronized void corruptBytes(long seed, double share) {
    set(false, new ByteCorrupter(seed, share)::corrupt, new ByteCorrupter(~seed, share)::corrupt);
  }

  /**
   * Has storms of up to 2000 random bytes come between what the device says, which itself is not
   * damaged. What the computer says comes through as it is.
   *
   * @param seed the same storms for the same pieces and seed
   */
  public synchronized void injectNoiseBursts(long seed) {
    set(false, SOUND, new NoiseBurstInjector(seed)::withNoise);
  }

  /** Makes it sound again. */
  public synchronized void restore() {
    set(false, SOUND, SOUND);
  }

  /**
   * Puts another device at its end: one of another kind, or the same that was switched off and on
   * and has forgotten its settings. An open link stays open.
   *
   * @param next nobody else may use it from now on
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

  /** Whether it is pulled out. */
  public synchronized boolean isPulled() {
    return pulled;
  }

  /** Bits per second of the device's line now; 0 where it is on none. */
  synchronized int baud() {
    return device.baud();
  }

  /**
   * Sets the speed of the computer's port. While it is not the device's, each of them reads
   * something else than the other sent.
   *
   * @param baud bits per second; 0 follows the device, as when nobody has set it
   */
  public synchronized void setPortBaud(int baud) {
    portBaud = baud;
  }

  /** Bits per second of the computer's port; 0 while it follows the device. */
  public synchronized int portBaud() {
    return portBaud;
  }

  /** A computer was put at the other end; the speed of its port is as somebody has set it. */
  synchronized void connected() {
    device.connected();
  }

  /** The computer at the other end is gone. */
  synchronized void disconnected() {
    device.disconnected();
  }

  /** Whether what the computer does not take at once is kept for it. */
  synchronized boolean buffersOutput() {
    return device.buffersOutput();
  }

  /** Takes bytes from the computer; they are under way from {@code now} on. */
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
   * Lets through what is through by {@code now}: to the device what the computer sent; to the
   * computer what is returned.
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

  /** What is read at a speed of what was sent at another; 0 is the other's. */
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
