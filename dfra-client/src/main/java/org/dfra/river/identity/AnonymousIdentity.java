package org.dfra.river.identity;

import java.math.BigInteger;
import java.security.GeneralSecurityException;
import java.security.cert.X509Certificate;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLSession;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509TrustManager;
import javax.security.auth.Subject;
import net.jini.core.constraint.InvocationConstraints;
import org.dfra.security.Decision;
import org.dfra.security.Guard;

/**
 * A client that has joined no team. It has no certificate, and cannot know whose the server's is:
 * its calls are encrypted, but it is a stranger to all servers, and they to it.
 */
public final class AnonymousIdentity implements ChannelIdentity {

  private static final String[] PROTOCOLS = {"TLSv1.3"};

  private final SSLContext context;

  private static final class Holder {
    static final AnonymousIdentity INSTANCE = new AnonymousIdentity();
  }

  private AnonymousIdentity() {
    try {
      context = SSLContext.getInstance("TLSv1.3");
      context.init(null, new TrustManager[] {new Anybody()}, null);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("this Java virtual machine has no TLS 1.3", e);
    }
  }

  /** The one of this virtual machine. */
  public static AnonymousIdentity instance() {
    return Holder.INSTANCE;
  }

  @Override
  public SSLEngine clientEngine(String host, int port) {
    SSLEngine engine = context.createSSLEngine(host, port);
    engine.setUseClientMode(true);
    engine.setEnabledProtocols(PROTOCOLS); // the context's own include older ones for clients
    return engine;
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalStateException always: nothing is exported without a certificate
   */
  @Override
  public SSLEngine serverEngine() {
    throw new IllegalStateException("a server needs a certificate");
  }

  @Override
  public ChannelPeer peer(SSLSession session, String address, boolean isServer) {
    return StrangerPeer.at(address);
  }

  @Override
  public Subject subject() {
    return StrangerPeer.NOBODY;
  }

  @Override
  public String robot() {
    return "";
  }

  @Override
  public InvocationConstraints requiredOfRobot(String name) {
    return InvocationConstraints.EMPTY;
  }

  @Override
  public boolean isRevoked(BigInteger certificate) {
    return false;
  }

  /** Without an authority there is no such list. */
  @Override
  public void addRevocationListener(Runnable listener) {}

  @Override
  public void removeRevocationListener(Runnable listener) {}

  @Override
  public Guard guard() {
    return request -> Decision.deny("anonymous", "nothing is exported without a certificate");
  }

  @Override
  public String toString() {
    return "a program that has joined no team";
  }

  /** Believes no server more than another: without an authority there is nothing to check. */
  private static final class Anybody implements X509TrustManager {

    @Override
    public void checkClientTrusted(X509Certificate[] chain, String type) {
      throw new IllegalStateException("a server needs a certificate");
    }

    @Override
    public void checkServerTrusted(X509Certificate[] chain, String type) {}

    @Override
    public X509Certificate[] getAcceptedIssuers() {
      return new X509Certificate[0];
    }
  }
}
