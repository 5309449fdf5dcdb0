package org.dfra.benchmarks.event;

import java.util.function.LongConsumer;

/** One way to tell other processes of events. The events are numbered from 1. */
interface EventTransport {

  /** What publishes events. */
  @FunctionalInterface
  interface EventSource {

    /** Publishes the next event; does not wait for the listeners. */
    void publish();
  }

  /** Makes this process the source. */
  record ServedSource(String address, EventSource source) {}

  /**
   * Makes this process the source of events.
   *
   * @return the source, and what a listener needs to find it, in one line
   * @throws Exception if it cannot be served
   */
  ServedSource serve() throws Exception;

  /**
   * Makes this process a listener, until it ends.
   *
   * @param address of the source
   * @param received is given the number of each event when it arrives, on any thread
   * @throws Exception if the source cannot be reached
   */
  void listen(String address, LongConsumer received) throws Exception;
}
