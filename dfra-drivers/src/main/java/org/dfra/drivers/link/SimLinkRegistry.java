package org.dfra.drivers.link;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.util.Set;
import java.util.TreeMap;

/**
 * The simulated devices of {@code sim:} links, by name. Each lock-step clock has its own registry,
 * so that several simulations in one virtual machine are separate. Safe for use by several threads.
 */
public final class SimLinkRegistry {

  /** The empty registry of real time. */
  static final SimLinkRegistry NONE =
      new SimLinkRegistry(
          "this module lives by real time, and sim: links are of a simulation in lock-step only;"
              + " write serial:, tcp: or replay:, or give the module the simulation's clock");

  /** Opens links to a simulated device. */
  @FunctionalInterface
  public interface LinkFactory {

    /**
     * Opens a link to the device.
     *
     * @param address the link's URL
     * @throws IOException if the device cannot be reached now; the message begins with the URL
     */
    SerialLink open(SimAddress address) throws IOException;
  }

  private final String whenEmpty;

  @GuardedBy("this")
  private final TreeMap<String, LinkFactory> ports = new TreeMap<>();

  /**
   * Makes a registry without devices.
   *
   * @param emptyReason why there is no device and how to add one, a clause; reported to callers
   *     that request a device from an empty registry
   */
  public SimLinkRegistry(String emptyReason) {
    this.whenEmpty = emptyReason;
  }

  /**
   * Adds a device.
   *
   * @param name the part of its link's URL after {@code sim:}
   * @throws IllegalArgumentException if the name is used already, or is not valid in a URL
   */
  public synchronized void add(String name, LinkFactory factory) {
    if (name.isBlank() || name.indexOf('?') >= 0) {
      throw new IllegalArgumentException(
          "\""
              + name
              + "\" cannot be the name of a simulated device: it must have characters, and"
              + " none of them may be a question mark");
    }
    if (this == NONE) {
      throw new IllegalArgumentException("sim:" + name + " cannot be added: " + whenEmpty);
    }
    if (ports.putIfAbsent(name, factory) != null) {
      throw new IllegalArgumentException(
          "there is a simulated device sim:" + name + " already; name this one otherwise");
    }
  }

  /** Removes a device. Does nothing if {@code factory} is not the current one of that name. */
  public synchronized void remove(String name, LinkFactory factory) {
    ports.remove(name, factory);
  }

  SerialLink open(SimAddress address) throws IOException {
    return find(address).open(address);
  }

  private synchronized LinkFactory find(SimAddress address) throws IOException {
    LinkFactory port = ports.get(address.name());
    if (port != null) {
      return port;
    }
    throw new IOException(
        address
            + ": there is no simulated device "
            + address.name()
            + (ports.isEmpty()
                ? "; " + whenEmpty
                : "; there are "
                    + String.join(", ", ports.keySet())
                    + ": name one of them, or have the simulation start "
                    + address.name()));
  }

  /**
   * A simulated device in this virtual machine: {@code sim:name}. Device, link and driver use the
   * same clock, in lock-step, so that runs are bit-for-bit repeatable.
   *
   * @param url the URL as configured
   * @param name the device's name in the {@link SimLinkRegistry} of the driver's clock
   */
  public record SimAddress(String url, String name) implements LinkAddress {

    static SimAddress of(LinkUrl parts) {
      parts.allow(Set.of());
      if (parts.target().isBlank()) {
        throw parts.fault("it names no simulated device; write sim:name");
      }
      return new SimAddress(parts.url(), parts.target());
    }

    @Override
    public SerialLink open(Ticker ticker) throws IOException {
      return ticker.simLinks().open(this);
    }

    @Override
    public String toString() {
      return url;
    }
  }
}
