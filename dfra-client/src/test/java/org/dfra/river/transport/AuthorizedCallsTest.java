package org.dfra.river.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.io.Serializable;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.river.access.GuardedObject;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.identity.AnonymousIdentity;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.security.AccessRefusedException;
import org.dfra.security.AccessRequest;
import org.dfra.security.Decision;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Calls of an exported object whose endpoint has a guard. */
class AuthorizedCallsTest {

  /** What the test calls. */
  public interface Wheels extends Remote {
    Object look() throws RemoteException;

    void drive(Object speed) throws RemoteException;
  }

  /** Notes that it was read. */
  public static final class Speed implements Serializable {

    @Serial private static final long serialVersionUID = 1L;

    static volatile int read;

    @Serial
    private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
      in.defaultReadObject();
      read++;
    }
  }

  private static final class WheelsImpl implements Wheels, GuardedObject {

    volatile int driven;

    @Override
    public Object look() {
      return driven;
    }

    @Override
    public void drive(Object speed) {
      driven++;
    }

    @Override
    public String guardedName() {
      return "drive";
    }
  }

  private final TestIdentities team = new TestIdentities(new TestTeam("field"));
  private final List<AccessRequest> requests = new CopyOnWriteArrayList<>();
  private final ChannelIdentity robot = team.guarded(MemberRole.ROBOT, "atrv1", this::decide);
  private final Uuid id = UuidFactory.generate();
  private final WheelsImpl impl = new WheelsImpl();
  private BasicJeriExporter exporter;
  private int port;

  private Decision decide(AccessRequest request) {
    requests.add(request);
    boolean isOperator =
        request.caller().member().filter(it -> it.role() == MemberRole.OPERATOR).isPresent();
    return isOperator || request.method().getName().equals("look")
        ? Decision.permit("test")
        : Decision.deny("only-operators-drive", "an operator may call it");
  }

  @BeforeEach
  void export() throws Exception {
    exporter =
        new BasicJeriExporter(
            RecordingServer.endpoint(robot), new DeadlineILFactory(), false, true, id);
    Remote proxy = exporter.export(impl);
    port = Objects.requireNonNull(PeerAddress.of(proxy)).port();
  }

  @AfterEach
  void unexport() {
    exporter.unexport(true);
  }

  private Wheels from(ChannelIdentity client) throws Exception {
    return CurrentIdentity.callAs(
        client,
        () ->
            (Wheels)
                DeadlineILFactory.proxy(
                    new BasicObjectEndpoint(
                        new TransportEndpoint(RecordingServer.HOST, port), id, false),
                    Duration.ofSeconds(20),
                    Wheels.class.getClassLoader(),
                    Wheels.class,
                    RemoteMethodControl.class));
  }

  @Test
  void theGuardDecidesByCallerAndMethod() throws Exception {
    from(team.of(MemberRole.OPERATOR, "anna")).drive(new Speed());
    assertThat(impl.driven).isEqualTo(1);
    AccessRequest request = requests.get(0);
    assertThat(request.robot()).isEqualTo("atrv1");
    assertThat(request.object()).isEqualTo("drive");
    assertThat(request.methodName()).isEqualTo("Wheels.drive");
    assertThat(request.caller()).hasToString("operator anna of field (127.0.0.1)");
  }

  @Test
  void aRefusedCallNeitherRunsNorIsItsArgumentBuilt() throws Exception {
    int before = Speed.read;
    Wheels observers = from(team.of(MemberRole.OBSERVER, "otto"));
    assertThat(observers.look()).isEqualTo(0);
    assertThatThrownBy(() -> observers.drive(new Speed()))
        .isInstanceOf(AccessRefusedException.class)
        .hasMessageContaining("Wheels.drive of drive is refused to observer otto of field")
        .hasMessageContaining("by rule only-operators-drive: an operator may call it");
    Wheels strangers = from(AnonymousIdentity.instance());
    assertThatThrownBy(() -> strangers.drive(new Speed()))
        .isInstanceOf(AccessRefusedException.class)
        .hasMessageContaining("is refused to a stranger (127.0.0.1)");
    assertThat(Speed.read).isEqualTo(before);
    assertThat(impl.driven).isZero();
    assertThat(observers.look()).as("the connection serves on").isEqualTo(0);
  }

  @Test
  void constraintsNameTheRobotThatMayAnswer() throws Exception {
    ChannelIdentity anna = team.of(MemberRole.OPERATOR, "anna");
    Wheels wheels = from(anna);
    assertThat(restricted(wheels, anna, "atrv1").look()).isEqualTo(0);
    int before = requests.size();
    Wheels wrong = restricted(wheels, anna, "atrv2");
    assertThatThrownBy(wrong::look)
        .hasRootCauseInstanceOf(UnsupportedConstraintException.class)
        .rootCause()
        .hasMessageContaining("the connection does not meet ServerMinPrincipal")
        .hasMessageContaining("CN=atrv1");
    assertThat(requests).hasSize(before);
  }

  private static Wheels restricted(Wheels wheels, ChannelIdentity client, String robot) {
    return (Wheels)
        ((RemoteMethodControl) wheels)
            .setConstraints(new BasicMethodConstraints(client.requiredOfRobot(robot)));
  }
}
