package org.dfra.sim.device;

import java.io.IOException;
import java.time.Duration;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.SimAddress;
import org.dfra.drivers.link.SimLinkRegistry;
import org.dfra.sim.time.LockStep;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * A device at the end of a {@code sim:} link, in lock-step with its driver.
 *
 * <p>It has one client at a time; a new one takes the place of the old. Bytes go both ways at the
 * pace of the device's line. The port looks every 5 ms and hands over as a computer's does: when
 * the line pauses, at the latest after 20 ms. Those that come out while there is no client are
 * lost.
 *
 * <p>No thread of its own: it is a repeated task of its time from {@link #start} to {@link #close},
 * which do nothing the second time.
 */
public final class SimPort implements AutoCloseable {

  private static final Duration POLL_INTERVAL = Duration.ofMillis(5);

  private final String name;
  private final Cable cable;
  private final LockStep time;
  private final SimLinkRegistry.LinkFactory port = this::open;

  // all guarded by this
  private @Nullable ScheduledTask pollTask;
  private boolean closed;
  private @Nullable SimLink client;

  /**
   * @param name the device's name: its link is {@code sim:name}
   * @param device the device; the port owns it from now on
   * @param time the time that device and driver live by
   */
  public SimPort(String name, SerialDevice device, LockStep time) {
    this.name = name;
    this.cable = new Cable(device);
    this.time = time;
  }

  /**
   * Switches the device on, and lets drivers find it.
   *
   * @throws IllegalArgumentException if there is another of this name
   */
  public synchronized void start() {
    if (closed) {
      throw new IllegalStateException("this port was closed; make a new one");
    }
    if (pollTask == null) {
      time.simLinks().add(name, port);
      pollTask = time.every(POLL_INTERVAL, this::poll);
    }
  }

  /** The link a driver finds it at: {@code sim:name}. */
  public String url() {
    return "sim:" + name;
  }

  /** The cable to the device, to have something wrong with it. */
  public Cable cable() {
    return cable;
  }

  @Override
  public synchronized void close() {
    closed = true;
    time.simLinks().remove(name, port);
    if (pollTask != null) {
      pollTask.cancel();
    }
    replaceClient(null);
  }

  private synchronized SerialLink open(SimAddress address) throws IOException {
    if (cable.isPulled()) {
      throw new IOException(address + ": the cable of this simulated device is pulled out");
    }
    SimLink link = new SimLink(address, time, cable, time);
    replaceClient(link);
    cable.setPortBaud(0); // it follows the device until the driver sets it
    cable.connected();
    return link;
  }

  private void replaceClient(@Nullable SimLink next) {
    if (client != null) {
      client.disconnect();
      cable.disconnected();
    }
    client = next;
  }

  /** Whether so few bytes have come since the last look that the line is silent now. */
  private boolean isPause(int count) {
    long most = cable.baud() * POLL_INTERVAL.toMillis() / 10_000; // ten bits a byte
    return most == 0 || count < most;
  }

  private synchronized void poll() {
    if (cable.isPulled()) {
      replaceClient(null);
    }
    byte[] bytes = cable.pass(time.instant());
    if (client != null) {
      client.deliver(bytes, isPause(bytes.length));
    }
  }
}
