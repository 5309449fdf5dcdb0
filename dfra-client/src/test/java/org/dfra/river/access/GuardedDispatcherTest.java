package org.dfra.river.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.Serial;
import java.io.Serializable;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketAddress;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.server.ExportException;
import java.rmi.server.UnicastRemoteObject;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import javax.net.SocketFactory;
import net.jini.admin.JoinAdmin;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.module.AdministrationRefusedException;
import org.dfra.module.Administrative;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.transport.SourceBoundEndpoint;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Calls from two addresses of the loopback: the robot's own, and a stranger's. */
class GuardedDispatcherTest {

  private static final String ROBOT = "127.0.0.1";
  private static final String STRANGER = "127.0.0.66";

  /** Not remote, as a module's interfaces are not. */
  public interface Settings {
    @Administrative
    void set(Object value) throws RemoteException;
  }

  /** Remote itself: the stubs of JRMP call no other methods. */
  public interface Reset extends Remote {
    @Administrative
    void reset() throws RemoteException;
  }

  /** What the test calls. */
  public interface Knobs extends Remote, Settings, JoinAdmin {
    Object get() throws RemoteException;
  }

  /** Notes that it was read. */
  public static final class Argument implements Serializable {

    @Serial private static final long serialVersionUID = 1L;

    static volatile int read;

    @Serial
    private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
      in.defaultReadObject();
      read++;
    }
  }

  private static final class KnobsImpl implements Knobs, Reset {

    volatile int calls;

    @Override
    public void set(Object value) {
      calls++;
    }

    @Override
    public void reset() {
      calls++;
    }

    @Override
    public Object get() {
      return calls;
    }

    @Override
    public Entry[] getLookupAttributes() {
      return new Entry[0];
    }

    @Override
    public void addLookupAttributes(Entry[] entries) {
      calls++;
    }

    @Override
    public void modifyLookupAttributes(Entry[] templates, Entry[] entries) {
      calls++;
    }

    @Override
    public String[] getLookupGroups() {
      return new String[] {"a"};
    }

    @Override
    public void addLookupGroups(String[] groups) {
      calls++;
    }

    @Override
    public void removeLookupGroups(String[] groups) {
      calls++;
    }

    @Override
    public void setLookupGroups(String[] groups) {
      calls++;
    }

    @Override
    public LookupLocator[] getLookupLocators() {
      return new LookupLocator[0];
    }

    @Override
    public void addLookupLocators(LookupLocator[] locators) {
      calls++;
    }

    @Override
    public void removeLookupLocators(LookupLocator[] locators) {
      calls++;
    }

    @Override
    public void setLookupLocators(LookupLocator[] locators) {
      calls++;
    }
  }

  private final Uuid id = UuidFactory.generate();
  private final KnobsImpl impl = new KnobsImpl();
  private final BasicJeriExporter exporter =
      new BasicJeriExporter(Endpoints.tcp(ROBOT, 0), new DeadlineILFactory(), false, true, id);
  private final List<Remote> guards = new ArrayList<>(); // RMI holds them weakly
  private final List<ServerSocket> listening = new ArrayList<>();
  private int port;

  @BeforeEach
  void export() throws Exception {
    assumeTrue(isAddressHere(STRANGER), STRANGER + " is no address of this computer");
    Remote proxy = exporter.export(impl);
    port = Objects.requireNonNull(PeerAddress.of(proxy)).port();
  }

  @AfterEach
  void unexport() throws IOException {
    for (Remote each : guards) {
      UnicastRemoteObject.unexportObject(each, true);
    }
    for (ServerSocket each : listening) { // RMI would leave them open
      each.close();
    }
    exporter.unexport(true);
  }

  private static boolean isAddressHere(String address) {
    try (ServerSocket bound = new ServerSocket(0, 1, InetAddress.getByName(address))) {
      return bound.isBound();
    } catch (IOException e) {
      return false;
    }
  }

  private Knobs from(String source) {
    return (Knobs)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(new SourceBoundEndpoint(ROBOT, port, source, 0), id, false),
            Duration.ofSeconds(20),
            Knobs.class.getClassLoader(),
            Knobs.class);
  }

  @Test
  void refusesAStrangerBeforeTheArgumentsAreRead() throws Exception {
    int before = Argument.read;
    assertThatThrownBy(() -> from(STRANGER).set(new Argument()))
        .isInstanceOf(AdministrationRefusedException.class)
        .hasMessage(
            "Settings.set is refused to 127.0.0.66: it is an administrative call, which is allowed"
                + " from the robot's own computer and from what <administration from=\"…\"> in its"
                + " XML names; call from there, or add the address and bring the robot up again");
    assertThat(Argument.read).isEqualTo(before);
    assertThat(impl.calls).isZero();
    from(ROBOT).set(new Argument());
    assertThat(Argument.read).isEqualTo(before + 1);
    assertThat(impl.calls).isEqualTo(1);
  }

  @Test
  void refusesWhatChangesByRiversInterfacesAndAnswersTheirQuestions() throws Exception {
    Knobs stranger = from(STRANGER);
    assertThatThrownBy(() -> stranger.setLookupGroups(new String[] {"b"}))
        .isInstanceOf(AdministrationRefusedException.class);
    assertThatThrownBy(() -> stranger.addLookupLocators(new LookupLocator[0]))
        .isInstanceOf(AdministrationRefusedException.class);
    assertThat(stranger.getLookupGroups()).containsExactly("a");
    assertThat(impl.calls).isZero();
    from(ROBOT).setLookupGroups(new String[] {"b"});
    assertThat(impl.calls).isEqualTo(1);
  }

  @Test
  void answersEverybodysQuestions() throws Exception {
    assertThat(from(STRANGER).get()).isEqualTo(0);
  }

  @Test
  void servesWhoIsAdmittedUntilThatIsOver() throws Exception {
    Knobs admitted = from(STRANGER);
    try (AdministrationPolicy.Admission unused =
        AdministrationPolicy.admit(List.of(AddressRange.of("127.0.0.66/31")))) {
      admitted.set("");
    }
    assertThat(impl.calls).isEqualTo(1);
    assertThatThrownBy(() -> admitted.set("")).isInstanceOf(AdministrationRefusedException.class);
  }

  @Test
  void aGuardInPlaceOfAnObjectLetsLocalCallsThrough() throws Exception {
    Knobs guarded = (Knobs) AdministrationGuard.of(impl, ROBOT);
    guarded.set("");
    assertThat(guarded.get()).isEqualTo(1);
    assertThatThrownBy(() -> AdministrationGuard.of(impl, "no such host"))
        .isInstanceOf(ExportException.class);
  }

  /** A guard of the object that is exported by JRMP, as its stub that calls from one address. */
  private Remote byJrmpFrom(String source) throws IOException {
    Remote guard = AdministrationGuard.of(impl, ROBOT);
    Remote stub =
        UnicastRemoteObject.exportObject(
            guard,
            0,
            (host, at) -> new Bound(source).createSocket(ROBOT, at),
            at -> {
              ServerSocket socket = new ServerSocket(at, 0, InetAddress.getByName(ROBOT));
              listening.add(socket);
              return socket;
            });
    guards.add(guard);
    return stub;
  }

  @Test
  void aGuardInPlaceOfAnObjectRefusesAStrangerByJrmp() throws Exception {
    Remote stranger = byJrmpFrom(STRANGER);
    assertThatThrownBy(() -> ((Reset) stranger).reset())
        .isInstanceOf(AdministrationRefusedException.class)
        .hasMessageStartingWith("Reset.reset is refused to 127.0.0.66: ");
    assertThat(impl.calls).isZero();
    assertThat(((Knobs) stranger).get()).as("a question").isEqualTo(0);
    ((Reset) byJrmpFrom(ROBOT)).reset();
    assertThat(impl.calls).isEqualTo(1);
  }

  @Test
  void aCallerWithoutAnAddressMayNotAdminister() throws Exception {
    AdministrationPolicy policy = AdministrationPolicy.exportedAt(ROBOT);
    assertThat(policy.allows(new RemoteCaller(null))).isFalse();
    assertThat(policy.allows(new RemoteCaller(InetAddress.getByName(ROBOT)))).isTrue();
    assertThat(RemoteCaller.current()).as("no remote call is in progress").isEmpty();
  }

  /** Sockets that connect from one address. */
  private static final class Bound extends SocketFactory {

    private final String source;

    Bound(String source) {
      this.source = source;
    }

    @Override
    public Socket createSocket() {
      return new Socket() {
        @Override
        public void connect(SocketAddress to, int millis) throws IOException {
          bind(new InetSocketAddress(InetAddress.getByName(source), 0));
          super.connect(to, millis);
        }
      };
    }

    @Override
    public Socket createSocket(String host, int port) throws IOException {
      return createSocket(InetAddress.getByName(host), port);
    }

    @Override
    public Socket createSocket(InetAddress host, int port) throws IOException {
      Socket socket = createSocket();
      socket.connect(new InetSocketAddress(host, port));
      return socket;
    }

    @Override
    public Socket createSocket(String host, int port, InetAddress local, int localPort)
        throws IOException {
      return createSocket(host, port);
    }

    @Override
    public Socket createSocket(InetAddress host, int port, InetAddress local, int localPort)
        throws IOException {
      return createSocket(host, port);
    }
  }
}
