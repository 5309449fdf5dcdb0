package org.dfra.drivers.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.time.Duration;

/**
 * A serial port with jSerialComm, read semi-blocking by one thread. Its listeners are not used:
 * they spin when the device is removed, while a semi-blocking read reports it.
 */
final class SerialPortLink implements SerialLink {

  /** The resolution of a read's timeout on Linux (VTIME); a shorter one would not wait at all. */
  private static final int TIMEOUT_STEP_MILLIS = 100;

  private static final int LONGEST_TIMEOUT_MILLIS = 25_500;

  private final SerialAddress address;
  private final SerialPort port;
  private volatile boolean open = true;
  private int timeoutMillis; // confined to the reading thread

  private SerialPortLink(SerialAddress address, SerialPort port, int timeoutMillis) {
    this.address = address;
    this.port = port;
    this.timeoutMillis = timeoutMillis;
  }

  static SerialLink open(SerialAddress address, int parity, int stop) throws IOException {
    SerialPort port;
    try {
      port = SerialPort.getCommPort(address.port());
    } catch (SerialPortInvalidPortException e) {
      throw new IOException(
          address + ": there is no port " + address.port() + "; is the device plugged in?", e);
    }
    port.setComPortParameters(address.baud(), address.bits(), stop, parity);
    port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
    port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, TIMEOUT_STEP_MILLIS, 0);
    if (!port.openPort()) {
      throw new IOException(
          address
              + ": the port cannot be opened (error "
              + port.getLastErrorCode()
              + "); is it in use, and may this user read and write it?");
    }
    port.flushIOBuffers(); // bytes received before the opening are outdated
    return new SerialPortLink(address, port, TIMEOUT_STEP_MILLIS);
  }

  @Override
  public int read(byte[] buffer, int offset, int length, Duration timeout) {
    if (!open) {
      return -1;
    }
    long steps = 1 + (Math.max(1, timeout.toMillis()) - 1) / TIMEOUT_STEP_MILLIS;
    int millis = (int) Math.min(LONGEST_TIMEOUT_MILLIS, steps * TIMEOUT_STEP_MILLIS);
    if (millis != timeoutMillis) {
      port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, millis, 0);
      timeoutMillis = millis;
    }
    int count = port.readBytes(buffer, length, offset);
    if (count < 0 || !open) {
      close();
      return -1;
    }
    return count;
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    int sent = 0;
    while (sent < bytes.length) {
      int count = open ? port.writeBytes(bytes, bytes.length - sent, sent) : -1;
      if (count <= 0) {
        throw new IOException(
            address + ": the port took " + sent + " of " + bytes.length + " bytes and is lost");
      }
      sent += count;
    }
  }

  @Override
  public void setBaud(int baud) throws IOException {
    if (!open || !port.setBaudRate(baud)) {
      throw new IOException(
          address + ": the port cannot be set to " + baud + " baud, or is lost; try a lower rate");
    }
  }

  @Override
  public boolean isOpen() {
    return open && port.isOpen();
  }

  @Override
  public void close() {
    open = false;
    port.closePort();
  }

  @Override
  public String toString() {
    return address.toString();
  }
}
