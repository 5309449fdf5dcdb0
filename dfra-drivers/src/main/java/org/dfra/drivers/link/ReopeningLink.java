package org.dfra.drivers.link;

/**
 * A link that is opened, and reopened whenever it is lost, from {@link #start} to {@link #close}.
 */
public interface ReopeningLink extends AutoCloseable {

  /** Starts to open the link, and returns without waiting for it. */
  void start();

  /** Closes the link permanently and returns when no more notifications will follow. */
  @Override
  void close();
}
