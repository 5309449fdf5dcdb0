package org.dfra.benchmarks.call;

import java.io.IOException;
import java.nio.file.Path;

/** One way to call a {@link EchoService} in another process. */
interface CallTransport {

  /** The address of all servers: the loopback. */
  String HOST = "127.0.0.1";

  /**
   * Prepares this process, server or client: the first thing that it does. Does nothing by default.
   *
   * @throws IOException if its configuration cannot be read
   */
  default void prepare() throws IOException {}

  /**
   * Serves {@link EchoServer} on the loopback until this process ends.
   *
   * @param folder an empty folder for files of the server, such as a socket; it is deleted
   * @return what a client needs to call it, in one line
   * @throws IOException if it cannot be served
   */
  String serve(Path folder) throws IOException;

  /**
   * Connects this process to a server.
   *
   * @param address what {@link #serve} returned
   * @throws IOException if the address cannot be used
   */
  Connection connect(String address) throws IOException;

  /** A client's process with a server. */
  @FunctionalInterface
  interface Connection {

    /**
     * For one further thread that calls.
     *
     * @throws IOException if no connection can be opened
     */
    Caller caller() throws IOException;
  }
}
