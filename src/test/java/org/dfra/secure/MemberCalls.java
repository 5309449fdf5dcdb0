package org.dfra.secure;

import java.nio.file.Path;
import java.security.PublicKey;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.awaitility.Awaitility;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.core.policy.method.MethodKinds;
import org.dfra.module.Module;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.RobotAlone;
import org.dfra.river.identity.StoredDelegations;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.security.Decision;

/**
 * Calls in the name of a member, from the test's own virtual machine: it has joined no team, so
 * that several members and a stranger can call from it.
 */
final class MemberCalls {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final TeamIdentity identity;

  /**
   * @param security the folder of the member's identity
   */
  MemberCalls(Path security) throws Exception {
    TeamCredentials member = IdentityFolder.load(security);
    Set<PublicKey> otherOwn =
        member.robotKey().map(it -> Set.of(it.certificate().getPublicKey())).orElse(Set.of());
    identity =
        new TeamIdentity(
            new TeamIdentity.Settings(
                member.member(),
                new TeamIdentity.Key(member.privateKey(), List.of(member.chain())),
                otherOwn,
                member.subject().getPrincipals(),
                member.authority(),
                new RevokedCertificates(member.authority()),
                request -> Decision.permit("test"),
                false),
            Clock.systemUTC());
  }

  private MemberCalls(TeamIdentity identity) {
    this.identity = identity;
  }

  /**
   * Calls with a robot's own key, as its processes call each other when nobody else would believe
   * them.
   */
  static MemberCalls alone(Path security) throws Exception {
    RobotAlone robot = IdentityFolder.loadAlone(security);
    return new MemberCalls(
        new TeamIdentity(
            new TeamIdentity.Settings(
                robot.member(),
                new TeamIdentity.Key(robot.key().key(), List.of(robot.key().certificate())),
                Set.of(),
                Set.of(),
                robot.authority(),
                new RevokedCertificates(robot.authority()),
                request -> Decision.permit("test"),
                false),
            Clock.systemUTC()));
  }

  /** Lets commands carry the delegations in a folder. */
  void carryDelegations(Path security) throws Exception {
    StoredDelegations delegations =
        new StoredDelegations(
            security,
            IdentityFolder.load(security),
            method ->
                MethodKinds.of(method.getDeclaringClass(), method).kind() == MethodKind.COMMAND,
            Clock.systemUTC());
    delegations.reload();
    identity.carry(delegations);
  }

  /** Calls: what is received and exported meanwhile keeps this identity. */
  <T, E extends Exception> T call(CurrentIdentity.Body<T, E> body) throws E {
    return CurrentIdentity.callAs(identity, body);
  }

  /** A module, {@code robot/name}, that a robot's registrar lists, as this member receives it. */
  <M extends Module> M find(int registrar, Class<M> kind, String path) throws Exception {
    return call(() -> listed(registrar, kind, path));
  }

  /** The same as the caller of this thread receives it: a stranger, if it is nobody. */
  static <M extends Module> M listed(int registrar, Class<M> kind, String path) {
    return Awaitility.await()
        .pollInSameThread()
        .atMost(PATIENCE)
        .ignoreExceptionsMatching(java.rmi.RemoteException.class::isInstance)
        .until(() -> look(registrar, kind, path), each -> each.isPresent())
        .orElseThrow();
  }

  private static <M extends Module> Optional<M> look(int registrar, Class<M> kind, String path)
      throws Exception {
    ServiceTemplate template = new ServiceTemplate(null, new Class<?>[] {kind}, null);
    for (ServiceItem item : registrar(registrar).lookup(template, 64).items) {
      if (kind.isInstance(item.service)
          && kind.cast(item.service).identification().path().equals(path)) {
        return Optional.of(kind.cast(item.service));
      }
    }
    return Optional.empty();
  }

  /** A registrar as the caller of this thread receives it. */
  static ServiceRegistrar registrar(int port) throws Exception {
    return new LookupLocator("jini://" + SecureTeam.HOST + ":" + port).getRegistrar();
  }
}
