package org.dfra.sim.device;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.SimLinkRegistry;
import org.dfra.drivers.link.SimLinkRegistry.SimAddress;
import org.dfra.sim.time.LockStep;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Connects an emulated device to a {@code sim:} link, in lock-step with its driver.
 *
 * <p>It has one client at a time; a new one replaces the old. Bytes pass in both directions at the
 * device's baud rate. The port polls every 5 ms and delivers as a computer's port does: when the
 * line is idle, at the latest after 20 ms. Output without a client is lost.
 *
 * <p>It has no thread of its own: it is a repeated task of its time from {@link #start} to {@link
 * #close}, which are idempotent.
 */
public final class SimPort implements AutoCloseable {

  private static final Duration POLL_INTERVAL = Duration.ofMillis(5);

  private final String name;
  private final Cable cable;
  private final LockStep time;
  private final SimLinkRegistry.LinkFactory port = this::open;

  @GuardedBy("this")
  private @Nullable ScheduledTask pollTask;

  @GuardedBy("this")
  private boolean closed;

  @GuardedBy("this")
  private @Nullable SimLink client;

  /**
   * @param name the device's name: its link is {@code sim:name}
   * @param device the device; the port owns it from now on
   * @param time that device and driver use
   */
  public SimPort(String name, SerialDevice device, LockStep time) {
    this.name = name;
    this.cable = new Cable(device);
    this.time = time;
  }

  /**
   * Switches the device on and registers the link.
   *
   * @throws IllegalArgumentException if the name is taken
   */
  public synchronized void start() {
    if (closed) {
      throw new IllegalStateException("this port was closed; create a new one");
    }
    if (pollTask == null) {
      time.simLinks().add(name, port);
      pollTask = time.every(POLL_INTERVAL, this::poll);
    }
  }

  /** The link for a driver: {@code sim:name}. */
  public String url() {
    return "sim:" + name;
  }

  /** The cable to the device, for fault injection. */
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
    cable.setPortBaud(0); // it uses the device's rate until the driver sets one
    cable.connected();
    return link;
  }

  @GuardedBy("this")
  private void replaceClient(@Nullable SimLink next) {
    if (client != null) {
      client.disconnect();
      cable.disconnected();
    }
    client = next;
  }

  /** Whether so few bytes have arrived since the last poll that the line is idle now. */
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
