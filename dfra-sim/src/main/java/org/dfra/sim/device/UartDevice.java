package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Instant;

/** A device that sends over a serial line, which paces its bytes. */
public abstract class UartDevice implements SerialDevice {

  private final UartLine channel;

  /**
   * @param baud bits per second of its serial line
   */
  protected UartDevice(int baud) {
    this.channel = new UartLine(baud);
  }

  /** Does what the device does by itself until that time. */
  protected abstract void advance(Instant time);

  /** The line to the computer. */
  protected final UartLine channel() {
    return channel;
  }

  @Override
  public final int baud() {
    return channel.baud();
  }

  @Override
  public void transmit(ByteBuffer out, Instant time) {
    advance(time);
    channel.drainTo(out, time);
  }
}
