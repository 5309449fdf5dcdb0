package org.dfra.river.identity;

import java.io.IOException;
import java.math.BigInteger;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLSession;
import javax.security.auth.Subject;
import net.jini.core.constraint.InvocationConstraints;
import org.dfra.security.Guard;

/**
 * Who this end of encrypted connections is, and whom it believes. Endpoints keep the identity that
 * was {@linkplain CurrentIdentity current} when they were made or received. Thread-safe.
 */
public interface ChannelIdentity {

  /**
   * An engine for the client's end of a connection, which offers TLS 1.3 only.
   *
   * @param host address or name of the server; sessions are resumed by it and the port
   * @param port TCP port of the server
   */
  SSLEngine clientEngine(String host, int port);

  /** An engine for the server's end, which accepts TLS 1.3 only and clients without certificate. */
  SSLEngine serverEngine();

  /**
   * The peer of a connection whose handshake is over, resumed sessions included.
   *
   * @param session of the connection
   * @param address numeric address of the peer
   * @param isServer whether the peer is the server of the connection
   * @throws IOException if the connection may not be used; the message says who the peer is and why
   */
  ChannelPeer peer(SSLSession session, String address, boolean isServer) throws IOException;

  /** The principals and credentials of this end; read-only. */
  Subject subject();

  /** Name of the robot whose identity it is; empty for persons and programs. */
  String robot();

  /**
   * What the connection to a server must have to be a robot's.
   *
   * @param name of the robot, in the own team; no constraints if there is none
   */
  InvocationConstraints requiredOfRobot(String name);

  /** Whether the team's authority has revoked the certificate of this number. */
  boolean isRevoked(BigInteger certificate);

  /**
   * Calls back after each new list of revoked certificates, until the listener is removed. Then
   * {@link ChannelPeer#isRevoked} is by the new list.
   *
   * @param listener must not wait; it is called on the thread that brought the list
   */
  void addRevocationListener(Runnable listener);

  /** Ends {@link #addRevocationListener}. */
  void removeRevocationListener(Runnable listener);

  /** Decides about calls to what is exported with this identity. */
  Guard guard();
}
