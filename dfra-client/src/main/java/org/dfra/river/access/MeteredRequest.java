package org.dfra.river.access;

/** A request of a transport that counts its bytes. */
public interface MeteredRequest {

  /**
   * The bytes that its connection has sent and received since the last call of this method for the
   * same connection. For the thread that serves the connection.
   */
  long takeBytes();

  /**
   * Runs something on the same thread when the response was sent, or could not be.
   *
   * @param action which does not fail
   */
  void whenEnded(Runnable action);
}
