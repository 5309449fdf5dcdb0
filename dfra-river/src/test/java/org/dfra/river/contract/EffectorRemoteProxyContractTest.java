package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.DriveState;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.effector.GrantedCommandLease;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.dfra.river.server.effector.DriveServer;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The proxy of an effector in another process, and what only remote clients need. */
class EffectorRemoteProxyContractTest extends EffectorContract {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  /** In the full form a busy computer may take longer until the lease is used. */
  private static final Duration UNRENEWED =
      Duration.ofSeconds(Boolean.getBoolean("dfra.full") ? 6 : 3);

  private DriveServer server;
  private DriveProxy proxy;

  @BeforeEach
  void serve() throws Exception {
    server = ServedDrive.serve(UUID.randomUUID(), ScriptedDrive.class);
    proxy = ServedDrive.far(server);
  }

  @AfterEach
  @Override
  void end() {
    server.close();
  }

  @Override
  DriveEffector effector() {
    return proxy;
  }

  @Override
  ScriptedDrive driver() {
    return ScriptedDrive.last(PATH);
  }

  @Override
  String commander() {
    return "a client at 127.0.0.1";
  }

  @Test
  void aCommanderThatDiedLosesTheEffectorWhenItsLeaseExpires() throws Exception {
    RemoteDriveEffector remote = (RemoteDriveEffector) server.getProxy();
    CommandLease dead = remote.acquireCommandLease(UNRENEWED); // what a proxy would renew
    assertThat(dead).isInstanceOf(GrantedCommandLease.class);
    remote.execute(dead.key(), new Velocity(0.5, 0));
    await().atMost(PATIENCE).until(() -> driver().leases().leases().isEmpty());
    await().atMost(PATIENCE).until(() -> driver().driveState().commander() == null);
    assertThat(driver().commands).startsWith("turn 0.5 0.0", "halt");
    assertThatThrownBy(() -> remote.execute(dead.key(), new Velocity(0.5, 0)))
        .isInstanceOf(CommandRefusedException.class);
    proxy.acquireCommandLease(Duration.ofSeconds(10)).close();
  }

  @Test
  void aClientThatCallsTheServerWithoutAProxyStopsItWithAnyName() throws Exception {
    RemoteDriveEffector remote = (RemoteDriveEffector) server.getProxy();
    assertThat(remote.emergencyStop(null).requester()).isEqualTo("somebody");
    assertThat(remote.releaseEmergencyStop(null).latched()).isFalse();
    EmergencyStopState stopped = remote.emergencyStop("\ud800" + "x".repeat(100_000));
    assertThat(stopped.latched()).isTrue();
    assertThat(stopped.requester()).isEqualTo("x".repeat(120) + "…");
    await().atMost(PATIENCE).until(() -> remote.emergencyStopState().haltCommanded());
    assertThat(driver().commands).containsOnly("halt");
  }

  @Test
  void aLivingCommandersLeaseIsRenewed() throws Exception {
    try (CommandLease lease = proxy.acquireCommandLease(Duration.ofSeconds(10))) {
      Instant first = lease.expiration();
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () -> assertThat(lease.expiration()).isAfter(first.plus(Duration.ofSeconds(2))));
      proxy.execute(lease.key(), new Velocity(0.1, 0));
      assertThat(lease.isLive()).isTrue();
    }
  }

  @Test
  void aLeaseThatWasLostDoesNotComeBack() throws Exception {
    RemoteDriveEffector remote = (RemoteDriveEffector) server.getProxy();
    AtomicReference<GrantedCommandLease> granted = new AtomicReference<>();
    RemoteDriveEffector seen =
        (RemoteDriveEffector)
            Proxy.newProxyInstance(
                RemoteDriveEffector.class.getClassLoader(),
                new Class<?>[] {RemoteDriveEffector.class},
                (self, method, arguments) -> {
                  Object result = method.invoke(remote, arguments);
                  if (result instanceof GrantedCommandLease command) {
                    granted.set(command);
                  }
                  return result;
                });
    CommandLease lease =
        new DriveProxy(seen, UUID.randomUUID(), proxy.identification())
            .acquireCommandLease(Duration.ofSeconds(10));
    granted.get().lease().cancel(); // the server knows it no more, its holder still renews it
    await().atMost(PATIENCE).until(() -> !lease.isLive());
    assertThat(driver().leases().leases()).isEmpty();
    assertThat(driver().driveState().commander()).isNull();
  }

  @Test
  void theCommanderAndItsHostAreListedAndCanBeRevokedByAdministrators() throws Exception {
    ModuleAdmin admin = (ModuleAdmin) proxy.getAdmin();
    CommandLease lease = proxy.acquireCommandLease(Duration.ofSeconds(10));
    LeaseStatus listed = admin.leases().get(0);
    assertThat(listed.role()).isEqualTo(LeaseRole.COMMANDER);
    assertThat(listed.host()).isEqualTo("127.0.0.1");
    assertThat(admin.revoke(listed.handle())).isTrue();
    assertThat(driver().commands).containsExactly("halt");
    await().atMost(PATIENCE).until(() -> !lease.isLive());
  }

  @Test
  void aCommanderInItsOwnVirtualMachineAndOneElsewhereExcludeEachOther() throws Exception {
    try (CommandLease far = proxy.acquireCommandLease(Duration.ofSeconds(10))) {
      assertThatThrownBy(() -> driver().acquireCommandLease(Duration.ofSeconds(10)))
          .hasMessageContaining("is commanded by a client at 127.0.0.1");
      driver().execute(far.key(), new Velocity(0.1, 0)); // anybody with the key may command
    }
    try (CommandLease near = driver().acquireCommandLease(Duration.ofSeconds(10))) {
      assertThatThrownBy(() -> proxy.acquireCommandLease(Duration.ofSeconds(10)))
          .hasMessageContaining("is commanded by a module in its own virtual machine");
      proxy.execute(near.key(), new Velocity(0.2, 0));
    }
    assertThat(driver().commands).containsExactly("turn 0.1 0.0", "halt", "turn 0.2 0.0", "halt");
  }

  /** Implements the kind, but nothing guards it. */
  public static final class Unguarded extends org.dfra.core.module.DeviceImpl
      implements DriveEffector {

    static volatile boolean made;

    public Unguarded(ModuleContext context) {
      super(
          context,
          "an unguarded drive",
          "DFRA",
          "1",
          java.util.List.of(),
          java.util.List.of(),
          java.util.List.of());
      made = true;
    }

    @Override
    protected void onStart() {}

    @Override
    protected void onClose() {}

    @Override
    protected java.util.List<? extends org.dfra.persona.Attributes> deviceAttributes() {
      return java.util.List.of();
    }

    @Override
    public CommandLease acquireCommandLease(Duration duration) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void execute(CommandKey key, DriveCommand command) {}

    @Override
    public EmergencyStopState emergencyStop(@Nullable String by) {
      return EmergencyStopState.NEVER;
    }

    @Override
    public EmergencyStopState releaseEmergencyStop(@Nullable String by) {
      return EmergencyStopState.NEVER;
    }

    @Override
    public EmergencyStopState emergencyStopState() {
      return EmergencyStopState.NEVER;
    }

    @Override
    public DriveState driveState() throws RemoteException {
      throw new UnsupportedOperationException();
    }
  }

  @Test
  void refusesToServeADriverThatNothingGuardsBeforeItIsEvenMade() {
    assertThatThrownBy(() -> ServedDrive.serve(UUID.randomUUID(), Unguarded.class))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("module atrv1/drive: driver " + Unguarded.class.getName())
        .hasMessageEndingWith(
            "is not a subclass of EffectorImpl that implements"
                + " org.dfra.flow.effector.DriveEffector");
    assertThat(Unguarded.made).isFalse();
  }
}
