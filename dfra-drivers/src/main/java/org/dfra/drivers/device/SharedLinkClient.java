package org.dfra.drivers.device;

/**
 * A module that shares a {@link SharedDeviceLink}. All methods are called by the line's reader
 * thread, one at a time, but for {@link #path}; they must not block.
 */
public interface SharedLinkClient {

  /** {@code robot/name}. */
  String path();

  /**
   * There is no device now.
   *
   * @param reason why, as a clause
   */
  void lost(String reason);
}
