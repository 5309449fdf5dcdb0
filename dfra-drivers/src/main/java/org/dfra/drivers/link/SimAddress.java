package org.dfra.drivers.link;

import java.io.IOException;
import java.util.Set;

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
