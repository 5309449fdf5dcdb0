package org.dfra.sim.device;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayDeque;

/** Sends back what it gets, at once, and writes down when it got it. For tests. */
final class EchoDevice implements SerialDevice {

  private final ArrayDeque<Byte> back = new ArrayDeque<>();
  private final ByteArrayOutputStream got = new ByteArrayOutputStream();
  private int baud;
  private int connections;
  private Instant last = Instant.MIN;

  EchoDevice(int baud) {
    this.baud = baud;
  }

  synchronized void setBaud(int next) {
    baud = next;
  }

  @Override
  public synchronized int baud() {
    return baud;
  }

  @Override
  public synchronized void receive(byte[] bytes, int offset, int length, Instant time) {
    got.write(bytes, offset, length);
    last = time;
    for (int i = offset; i < offset + length; i++) {
      back.add(bytes[i]);
    }
  }

  @Override
  public synchronized void transmit(ByteBuffer out, Instant time) {
    while (out.hasRemaining() && !back.isEmpty()) {
      out.put(back.remove());
    }
  }

  @Override
  public synchronized void connected() {
    connections++;
  }

  /** How many computers there have been. */
  synchronized int connections() {
    return connections;
  }

  /** What it has got so far. */
  synchronized String got() {
    return got.toString(StandardCharsets.US_ASCII);
  }

  /** When it got the last of it. */
  synchronized Instant last() {
    return last;
  }
}
