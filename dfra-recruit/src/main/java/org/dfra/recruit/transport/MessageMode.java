package org.dfra.recruit.transport;

/** Transmission of a message to all. */
public enum MessageMode {
  /** One transmission that all receive. */
  BROADCAST,
  /** One transmission to each receiver. */
  UNICAST
}
