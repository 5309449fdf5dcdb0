package org.dfra.drivers.gps.m12;

/**
 * {@code @@As}: the position that is held in position hold; also the acknowledgement of setting it.
 *
 * @param position the position; only its height above the ellipsoid is valid
 */
public record HeldPosition(M12Position position) implements M12Message {

  @Override
  public String id() {
    return "As";
  }
}
