package org.dfra.recruit.transport;

/** How a message to all is sent. */
public enum MessageMode {
  /** One transmission that all hear. */
  BROADCAST,
  /** One transmission to each. */
  UNICAST
}
