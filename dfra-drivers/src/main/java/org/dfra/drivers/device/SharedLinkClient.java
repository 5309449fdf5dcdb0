package org.dfra.drivers.device;

/**
 * A module that shares a {@link SharedDeviceLink}. The link's reader thread calls all methods
 * except {@link #path}, one at a time; they must not block.
 */
public interface SharedLinkClient {

  /** {@code robot/name}. */
  String path();

  /**
   * The device is lost.
   *
   * @param reason why, as a clause
   */
  void lost(String reason);
}
