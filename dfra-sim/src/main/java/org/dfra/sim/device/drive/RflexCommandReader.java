package org.dfra.sim.device.drive;

import java.io.ByteArrayOutputStream;

/**
 * Parses commands from the bytes that a computer sends. As a controller without an escape for 1B,
 * it reads 1B 02 as a start and 1B 03 as an end wherever they occur; a 1B before anything else
 * corrupts its frame. Confined to one thread.
 */
final class RflexCommandReader {

  /** Receives parsed commands. */
  @FunctionalInterface
  interface Sink {

    /**
     * Handles one command.
     *
     * @param port which part of the controller
     * @param opcode operation to execute
     * @param data the bytes between length and checksum
     */
    void command(int port, int opcode, byte[] data);
  }

  private static final int ESCAPE = 0x1B;
  private static final int START = 0x02;
  private static final int END = 0x03;
  private static final int HEAD = 4;

  private final Sink sink;
  private final ByteArrayOutputStream frame = new ByteArrayOutputStream();
  private boolean inFrame;
  private boolean escaped;
  private long spoiled;

  RflexCommandReader(Sink sink) {
    this.sink = sink;
  }

  /** Frames that were begun and not executed. */
  long malformedFrames() {
    return spoiled;
  }

  void feed(byte[] bytes, int offset, int length) {
    for (int i = offset; i < offset + length; i++) {
      take(bytes[i] & 0xFF);
    }
  }

  private void take(int value) {
    if (escaped) {
      escaped = false;
      control(value);
    } else if (value == ESCAPE) {
      escaped = true;
    } else if (inFrame) {
      frame.write(value);
    }
  }

  private void control(int value) {
    if (value == END && inFrame) {
      dispatch(frame.toByteArray());
    } else if (inFrame) {
      spoiled++;
    }
    inFrame = value == START;
    escaped = value == ESCAPE;
    frame.reset();
  }

  private void dispatch(byte[] found) {
    int sum = 0;
    for (byte each : found) {
      sum ^= each; // the checksum makes it zero
    }
    int length = found.length - HEAD - 1;
    if (length < 0 || (found[3] & 0xFF) != length || (sum & 0xFF) != 0) {
      spoiled++;
      return;
    }
    byte[] data = new byte[length];
    System.arraycopy(found, HEAD, data, 0, length);
    sink.command(found[0], found[2] & 0xFF, data);
  }
}
