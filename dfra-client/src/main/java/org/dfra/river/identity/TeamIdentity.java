package org.dfra.river.identity;

import java.io.IOException;
import java.lang.reflect.Method;
import java.math.BigInteger;
import java.net.InetAddress;
import java.security.GeneralSecurityException;
import java.security.Principal;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.time.InstantSource;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.net.ssl.KeyManager;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLPeerUnverifiedException;
import javax.net.ssl.SSLSession;
import javax.net.ssl.SSLSessionContext;
import javax.net.ssl.TrustManager;
import javax.security.auth.Subject;
import javax.security.auth.x500.X500Principal;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.ServerAuthentication;
import net.jini.core.constraint.ServerMinPrincipal;
import org.dfra.river.access.NumericAddress;
import org.dfra.river.access.OwnAddresses;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Guard;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;

/** A member of a team at one end of encrypted connections. */
public final class TeamIdentity implements ChannelIdentity {

  private static final String[] PROTOCOLS = {"TLSv1.3"};
  private static final String[] SUITES = {
    "TLS_AES_128_GCM_SHA256", "TLS_AES_256_GCM_SHA384", "TLS_CHACHA20_POLY1305_SHA256"
  };

  /** The longest time between two full handshakes of a client and a server. */
  private static final int SESSION_SECONDS = 3600;

  /** The most peers whose sessions are kept. */
  private static final int SESSIONS = 512;

  private final Member member;
  private final Subject subject;
  private final MemberTrust trust;
  private final Guard guard;
  private final RevokedCertificates revoked;
  private final SSLContext context;
  private final X509Certificate own;
  private final boolean isIssued; // by the authority; otherwise it is a robot's own key
  private final boolean believesExpired;
  private final DelegationVerifier delegations;
  private volatile OutgoingCredentials outgoing = (method, server) -> null;

  /**
   * The key of a member.
   *
   * @param key its private key
   * @param chain the key's certificate first; the authority's may follow
   */
  public record Key(PrivateKey key, List<X509Certificate> chain) {

    /** Copies the chain. */
    public Key {
      chain = List.copyOf(chain);
    }

    PublicKey publicKey() {
      return chain.get(0).getPublicKey();
    }
  }

  /**
   * What an identity consists of.
   *
   * @param member who it is
   * @param key what it presents
   * @param otherOwn further public keys that only this robot or person has
   * @param principals those that logging in has given it, the member excluded
   * @param revoked certificates, with the authority that revokes them
   * @param authority the team's
   * @param guard decides about calls to what is exported
   * @param believesExpired whether servers with an expired certificate are called, which only
   *     stopping them needs
   */
  public record Settings(
      Member member,
      Key key,
      Set<PublicKey> otherOwn,
      Set<Principal> principals,
      X509Certificate authority,
      RevokedCertificates revoked,
      Guard guard,
      boolean believesExpired) {}

  /**
   * An identity.
   *
   * @param clock for the validity of certificates; a {@link FlooredClock} that is not set learns
   *     from those of others
   * @throws GeneralSecurityException if this virtual machine cannot use the key with TLS 1.3
   */
  public TeamIdentity(Settings settings, InstantSource clock) throws GeneralSecurityException {
    this.member = settings.member();
    this.guard = settings.guard();
    this.believesExpired = settings.believesExpired();
    X509Certificate certificate = settings.key().chain().get(0);
    this.own = certificate;
    this.isIssued =
        certificate.getIssuerX500Principal().equals(settings.authority().getSubjectX500Principal());
    Set<Principal> principals = new LinkedHashSet<>(settings.principals());
    principals.add(member);
    principals.add(member.x500());
    principals.add(certificate.getSubjectX500Principal());
    this.subject = new Subject(true, principals, Set.of(certificate), Set.of());
    Set<PublicKey> ownKeys = new HashSet<>(settings.otherOwn());
    ownKeys.add(settings.key().publicKey());
    this.revoked = settings.revoked();
    this.trust =
        new MemberTrust(settings.authority(), member.team(), ownKeys, settings.revoked(), clock);
    this.delegations = new DelegationVerifier(member, trust, clock);
    this.context = SSLContext.getInstance("TLSv1.3");
    context.init(
        new KeyManager[] {new OwnKey(settings.key().key(), settings.key().chain())},
        new TrustManager[] {trust},
        null);
    limit(context.getServerSessionContext());
    limit(context.getClientSessionContext());
  }

  private static void limit(SSLSessionContext sessions) {
    sessions.setSessionTimeout(SESSION_SECONDS);
    sessions.setSessionCacheSize(SESSIONS);
  }

  /**
   * Checks that the team's authority has issued a certificate to a member, and not revoked it. It
   * may have expired. The own one is believed too.
   *
   * @throws CertificateException if not; the message says why
   */
  public void requireMember(X509Certificate certificate) throws CertificateException {
    trust.checkClientTrusted(new X509Certificate[] {certificate}, certificate.getSigAlgName());
  }

  /** The certificate that it shows. */
  public X509Certificate certificate() {
    return own;
  }

  /** Who it is. */
  public Member member() {
    return member;
  }

  /** Lets calls to other members carry credentials from now on. */
  public void carry(OutgoingCredentials credentials) {
    outgoing = credentials;
  }

  @Override
  public SSLEngine clientEngine(String host, int port) {
    SSLEngine engine = engine(host, port);
    engine.setUseClientMode(true);
    return engine;
  }

  @Override
  public SSLEngine serverEngine() {
    SSLEngine engine = context.createSSLEngine();
    engine.setUseClientMode(false);
    engine.setWantClientAuth(true);
    return narrowed(engine);
  }

  private SSLEngine engine(String host, int port) {
    return narrowed(context.createSSLEngine(host, port));
  }

  private static SSLEngine narrowed(SSLEngine engine) {
    engine.setEnabledProtocols(PROTOCOLS);
    engine.setEnabledCipherSuites(SUITES);
    return engine;
  }

  @Override
  public ChannelPeer peer(SSLSession session, String address, boolean isServer) throws IOException {
    X509Certificate certificate;
    try {
      certificate = (X509Certificate) session.getPeerCertificates()[0];
    } catch (SSLPeerUnverifiedException e) {
      if (isServer) {
        throw e;
      }
      return StrangerPeer.at(address);
    }
    Known known = new Known(member(certificate), certificate, address, isServer);
    if (known.isRevoked()) { // a resumed session was checked long ago
      throw new IOException(known.who + " is not called or answered: " + reason(certificate));
    }
    return known;
  }

  private boolean isBelieved(Standing standing, boolean isServer) {
    return switch (standing) {
      case OWN, MEMBER -> true;
      case EXPIRED -> !isServer || believesExpired;
      case STRANGER -> false;
    };
  }

  private String reason(X509Certificate certificate) {
    if (isRevoked(certificate)) {
      return "its certificate is revoked";
    }
    return trust.standing(certificate) == Standing.OWN
        ? "the authority has not issued the certificate of its key, which is for this computer only"
        : "its certificate is valid from "
            + certificate.getNotBefore().toInstant()
            + " until "
            + certificate.getNotAfter().toInstant();
  }

  /** With this identity's certificate its keys are revoked, whatever certificates they have. */
  private boolean isRevoked(X509Certificate certificate) {
    return trust.isRevoked(certificate)
        || (trust.standing(certificate) == Standing.OWN && trust.isRevoked(own));
  }

  /** The key that a robot's processes have among themselves has no name of a member. */
  private Member member(X509Certificate certificate) {
    return trust.standing(certificate) == Standing.OWN
        ? member
        : Member.of(certificate.getSubjectX500Principal());
  }

  @Override
  public Subject subject() {
    return subject;
  }

  @Override
  public String robot() {
    return member.role() == MemberRole.ROBOT ? member.name() : "";
  }

  @Override
  public InvocationConstraints requiredOfRobot(String name) {
    X500Principal robot = new Member(member.team(), MemberRole.ROBOT, name).x500();
    return new InvocationConstraints(
        new InvocationConstraint[] {ServerAuthentication.YES, new ServerMinPrincipal(robot)},
        new InvocationConstraint[0]);
  }

  @Override
  public boolean isRevoked(BigInteger certificate) {
    return revoked.contains(certificate);
  }

  @Override
  public void addRevocationListener(Runnable listener) {
    revoked.addListener(listener);
  }

  @Override
  public void removeRevocationListener(Runnable listener) {
    revoked.removeListener(listener);
  }

  @Override
  public Guard guard() {
    return guard;
  }

  @Override
  public String toString() {
    return member.toString();
  }

  /** A peer with a certificate. */
  private final class Known implements ChannelPeer {

    private final Member who;
    private final X509Certificate certificate;
    private final String address;
    private final boolean isLocal;
    private final boolean isThisComputer; // which has the whole loopback, also for several robots
    private final boolean isServer;
    private final Subject subject;

    Known(Member who, X509Certificate certificate, String address, boolean isServer) {
      this.isServer = isServer;
      this.who = who;
      this.certificate = certificate;
      this.address = address;
      @Nullable InetAddress from = NumericAddress.parse(address);
      this.isLocal = from != null && OwnAddresses.isAlwaysLocal(from);
      this.isThisComputer = isLocal || (from != null && from.isLoopbackAddress());
      Set<Principal> principals = new LinkedHashSet<>();
      principals.add(who);
      principals.add(who.x500());
      if (trust.standing(certificate) != Standing.OWN) { // who has the own key may write any name
        principals.add(certificate.getSubjectX500Principal());
      }
      this.subject = new Subject(true, principals, Set.of(certificate), Set.of());
    }

    @Override
    public Caller caller() {
      Standing standing = standing();
      return standing == Standing.STRANGER
          ? Caller.stranger(address)
          : new Caller(standing, Optional.of(who), address);
    }

    @Override
    public Subject subject() {
      return standing() == Standing.STRANGER ? StrangerPeer.NOBODY : subject;
    }

    private Standing standing() {
      Standing standing = trust.standing(certificate);
      if (standing == Standing.MEMBER && who.equals(member)) {
        return Standing.OWN; // with the certificate before or after a renewal
      }
      return standing != Standing.OWN || isOwnHere() ? standing : Standing.STRANGER;
    }

    /**
     * A revoked key may be in other hands: elsewhere it is nobody's. So is a key that the authority
     * knows nothing of, and cannot revoke: that between a robot's processes.
     */
    private boolean isOwnHere() {
      return (isLocal || !TeamIdentity.this.isRevoked(certificate))
          && (isThisComputer || (certificate.equals(own) && isIssued));
    }

    @Override
    public List<BigInteger> certificateNumbers() {
      boolean isOwnWork =
          isThisComputer && (trust.standing(certificate) == Standing.OWN || who.equals(member));
      return isOwnWork ? List.of() : List.of(certificate.getSerialNumber());
    }

    @Override
    public boolean isRevoked() {
      return !isBelieved(standing(), isServer);
    }

    /** The own processes need nobody else's right. */
    @Override
    public byte @Nullable [] credentialFor(Method method) {
      return isServer && standing() == Standing.MEMBER ? outgoing.of(method, who) : null;
    }

    @Override
    public void receive(byte[] credential, Collection<Object> context) {
      Caller alone = caller();
      if (alone.standing() == Standing.STRANGER) {
        return; // nobody acts for a member without being one
      }
      ChannelPeer peer = this;
      Caller caller;
      try {
        Delegation delegation = delegations.signed(credential);
        Optional<String> fault = delegations.fault(delegation, who, certificate);
        if (fault.isEmpty()) {
          peer = new DelegatedPeer(this, delegation, delegations);
          caller = alone.onBehalfOf(Behalf.of(delegation.principal()));
        } else {
          caller = alone.onBehalfOf(Behalf.unproved(fault.get()));
        }
      } catch (IdentityException e) {
        caller = alone.onBehalfOf(Behalf.unproved(String.valueOf(e.getMessage())));
      }
      context.removeIf(each -> each instanceof Caller || each == this);
      context.add(caller);
      context.add(peer);
    }

    @Override
    public String toString() {
      return who.toString();
    }
  }
}
