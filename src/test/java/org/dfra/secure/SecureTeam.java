package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.app.MarkedProcesses;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.PhoenixProcess;

/**
 * The team {@code field} with its authority, whose members have a state folder each, as if they had
 * a computer each. The first operator, anna, has the authority.
 */
final class SecureTeam implements AutoCloseable {

  static final String HOST = "127.0.0.1";
  static final String ANNA = "anna";
  static final Duration PATIENCE = Duration.ofSeconds(150);

  private final Path folder;
  private final Map<String, MarkedProcesses> processes = new ConcurrentHashMap<>();
  private final Map<String, Integer> registrars = new ConcurrentHashMap<>();

  /**
   * @param folder of this test alone
   */
  SecureTeam(Path folder) {
    this.folder = folder;
  }

  /** The state folder of a member, or of somebody who has joined no team. */
  Path state(String who) {
    return own(who).resolve("state");
  }

  /** The folder of a member's identity. */
  Path security(String who) {
    return state(who).resolve("security");
  }

  private Path own(String who) {
    try {
      return Files.createDirectories(folder.resolve(who));
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  private MarkedProcesses processes(String who) {
    return processes.computeIfAbsent(
        who,
        name ->
            new MarkedProcesses(own(name))
                .set("HOME", own(name).toString())
                .set("DFRA_STATE", "")
                .set("DFRA_LOCATORS", "")
                .set("DFRA_PHOENIX", ""));
  }

  /** Runs {@code ./dfra} as somebody, in a process. */
  Outcome dfra(String who, String... words) throws Exception {
    return processes(who).dfra(PATIENCE, with(words, "--state=" + state(who)));
  }

  /** The same, of a command that looks for the team's robots. */
  Outcome ask(String who, String... words) throws Exception {
    boolean isPatient = Stream.of(words).noneMatch(word -> word.startsWith("--wait="));
    String[] all = with(words, "--team=", "--host=" + HOST, "--locator=" + locators());
    return dfra(who, isPatient ? with(all, "--wait=20") : all);
  }

  /** {@link #dfra} in the test's own process, for what calls nobody. */
  Outcome here(String who, String... words) {
    return MarkedProcesses.here(with(words, "--state=" + state(who)));
  }

  private static String[] with(String[] words, String... more) {
    return Stream.concat(Stream.of(words), Stream.of(more)).toArray(String[]::new);
  }

  private String locators() {
    return registrars.values().stream()
        .map(port -> HOST + ":" + port)
        .collect(Collectors.joining(","));
  }

  static Outcome ok(Outcome outcome) {
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isZero();
    return outcome;
  }

  /** Makes the authority, and operator anna. */
  void init() {
    ok(here(ANNA, "security", "init", "field", "--no-passphrase", "--operator=" + ANNA));
  }

  /** Issues a bundle, and joins with it. */
  void admit(String role, String name) throws IOException {
    String[] issue = issueWords(role, name);
    ok(here(ANNA, issue));
    ok(here(name, joinWords(name)));
  }

  String[] issueWords(String role, String name) {
    return new String[] {
      "security",
      "issue",
      role,
      name,
      "--out=" + bundle(name),
      "--passphrase-file=" + own(name).resolve("passphrase")
    };
  }

  String[] joinWords(String name) {
    return new String[] {
      "security",
      "join",
      bundle(name).toString(),
      "--passphrase-file=" + own(name).resolve("passphrase")
    };
  }

  private Path bundle(String name) {
    return own(name).resolve(name + ".bundle");
  }

  /** Revokes a member, and carries the list to others. */
  void revoke(String name, String... members) throws IOException {
    ok(here(ANNA, "security", "revoke", name, "--reason=laptop lost"));
    for (String each : members) {
      carryRevocations(each);
    }
  }

  private void carryRevocations(String member) throws IOException {
    Path list = state(ANNA).resolve("authority").resolve("revoked.crl");
    Path beside = security(member).resolve("revoked.new");
    Files.copy(list, beside, StandardCopyOption.REPLACE_EXISTING);
    Files.move(beside, security(member).resolve("revoked.crl"), StandardCopyOption.ATOMIC_MOVE);
  }

  /** The port of a robot's registrar, which is chosen when it is first asked for. */
  int registrar(String robot) {
    return registrars.computeIfAbsent(
        robot,
        name -> {
          try {
            return FreePorts.allocate();
          } catch (IOException e) {
            throw new IllegalStateException(e);
          }
        });
  }

  /** Another registrar that commands ask from now on. */
  void alsoAsk(int registrar) {
    registrars.put("registrar of others", registrar);
  }

  /** Ends {@link #alsoAsk}. */
  void askNoMore() {
    registrars.remove("registrar of others");
  }

  /** The phoenix of a robot that is up. */
  PhoenixProcess phoenix(String robot) throws IOException {
    String address = Files.readString(state(robot).resolve("phoenix.address")).strip();
    int port = Integer.parseInt(address.substring(address.lastIndexOf(':') + 1));
    return new PhoenixProcess(HOST, port, -1, state(robot));
  }

  /** Writes a robot's description with these groups, in which %d is its registrar's port. */
  Path describe(String robot, String groups) throws IOException {
    return Files.writeString(
        own(robot).resolve("robot.xml"),
        "<robot xmlns=\"urn:dfra:robot:1\" name=\"%s\" host=\"%s\">%n%s</robot>%n"
            .formatted(robot, HOST, groups.formatted(registrar(robot))));
  }

  /** Brings a robot up. */
  Outcome up(String robot) throws Exception {
    List<String> words = new ArrayList<>(List.of("up", own(robot).resolve("robot.xml").toString()));
    if (!Files.exists(state(robot).resolve("phoenix.address"))) {
      words.add("--port=" + FreePorts.allocate());
    }
    return dfra(robot, words.toArray(String[]::new));
  }

  /** The processes of a robot that live now. */
  List<ProcessHandle> living(String robot) {
    return processes(robot).living();
  }

  /** Ends a process with -9. */
  static void kill(ProcessHandle process) {
    boolean unused = process.destroyForcibly();
    await().atMost(PATIENCE).until(() -> !process.isAlive());
  }

  @Override
  public void close() {
    processes.values().forEach(MarkedProcesses::close);
  }
}
