package org.dfra.drivers.link;

import java.io.IOException;
import java.util.Set;

/**
 * A simulated device in this virtual machine: {@code sim:name}. Device, link and driver go by the
 * same time, in lock-step, so that a run can be repeated bit by bit.
 *
 * @param url the address as written
 * @param name the device's name among the {@link SimLinkRegistry} of the driver's time
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
