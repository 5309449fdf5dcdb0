package org.dfra.benchmarks.call;

import java.io.IOException;

/** Calls a served {@link EchoService} by one peer. Used by one thread at a time. */
interface Caller extends AutoCloseable {

  /** Returns the server's answer to {@link EchoService#echo}. */
  long echo(long value) throws IOException;

  /** Returns the server's answer to {@link EchoService#values}. */
  double[] values() throws IOException;

  @Override
  default void close() {}
}
