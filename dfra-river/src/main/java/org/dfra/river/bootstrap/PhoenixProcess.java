package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.rmi.AccessException;
import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.call.ConnectionRefusal;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.phoenix.PhoenixIdentities;
import org.dfra.river.phoenix.PhoenixLocator;
import org.dfra.river.phoenix.ProcessIdentity;
import org.dfra.river.security.SecureProcess;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Step 1 of the bootstrap: phoenix, in a process of its own.
 *
 * @param host address or name that activation proxies carry
 * @param port TCP port of the activation system
 * @param registryPort port of the read-only RMI registry, or −1 for none
 * @param state folder of phoenix's journal and of its groups' output; other users may not enter it
 */
public record PhoenixProcess(String host, int port, int registryPort, Path state) {

  private static final Logger LOG = LoggerFactory.getLogger(PhoenixProcess.class);

  private static final Duration DEADLINE = Duration.ofSeconds(10);
  private static final String MAIN = Phoenix.class.getName();
  private static final long LOOK_AGAIN_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

  /**
   * The activation system's proxy; nothing is sent before its first call.
   *
   * @throws ConnectException if no phoenix was ever started with this state
   * @throws AccessException if phoenix, or what listens on its port, is another user's
   */
  public ActivationSystem system() throws RemoteException {
    return system(DEADLINE);
  }

  private ActivationSystem system(Duration deadline) throws RemoteException {
    ActivationSystem system = PhoenixLocator.system(host, port, journal(), deadline);
    requireOwnPort(); // a call carries the identity
    return system;
  }

  /**
   * Phoenix's administration interface.
   *
   * @param deadline timeout of each call
   * @throws ConnectException if no phoenix was ever started with this state
   * @throws AccessException if phoenix, or what listens on its port, is another user's
   */
  public PhoenixAdmin admin(Duration deadline) throws RemoteException {
    return (PhoenixAdmin) system(deadline);
  }

  /**
   * Throws if phoenix belongs to another user: only that user and root may call it.
   *
   * @throws AccessException with the owner's name, if its identity cannot be read or its port
   *     belongs to another user
   */
  public void requireOwnedByUser() throws AccessException {
    try {
      ActivationSystem unused = PhoenixLocator.system(host, port, journal(), DEADLINE);
    } catch (AccessException e) {
      throw e;
    } catch (RemoteException e) {
      LOG.debug("No phoenix was started with {} yet.", state, e);
    }
    requireOwnPort();
  }

  private void requireOwnPort() throws AccessException {
    PortOwner owners = PortOwner.system();
    OptionalInt owner = owners.uidOf(host, port);
    if (owner.isPresent() && owner.getAsInt() != expectedOwner()) {
      throw new AccessException(
          "port "
              + port
              + " of "
              + host
              + " is held by a process of user "
              + owners.userName(owner.getAsInt())
              + ", such as that user's phoenix, and not by the phoenix of "
              + state
              + "; name another port with --port, or that user's folder with --state");
    }
  }

  /** The UID that phoenix must run under: the owner of its identity file, or else this user. */
  private int expectedOwner() throws AccessException {
    Path identity = journal().resolve(PhoenixIdentities.FILE);
    Path owned = Files.exists(identity) ? identity : Path.of("/proc/self");
    try {
      return (Integer) Files.getAttribute(owned, "unix:uid");
    } catch (IOException e) {
      throw new AccessException("the owner of " + owned + " cannot be read (" + e + ")");
    }
  }

  private Path journal() {
    return state.resolve("journal");
  }

  /** Whether a phoenix answers at the address. */
  public boolean isResponding() {
    try {
      admin().groupStatus();
      return true;
    } catch (RemoteException e) {
      return false;
    }
  }

  /**
   * Whether a phoenix answers at the address. If it may be running but does not answer, the call is
   * repeated: on a busy computer a timeout does not prove its end.
   *
   * @param time time limit for the calls
   * @return false if no process listens there, another program answers, or the process that owned
   *     the journal has certainly ended
   * @throws NoAnswerException if none of that is known at the time limit
   */
  public boolean isResponding(Duration time) throws NoAnswerException {
    try {
      List<GroupStatus> unused = groupStatus(DEADLINE, time);
      return true;
    } catch (NoAnswerException e) {
      throw e;
    } catch (RemoteException e) {
      return false;
    }
  }

  /**
   * The status of its groups; retried as in {@link #isResponding(Duration)}.
   *
   * @param deadline timeout of each call
   * @param time time limit for all calls
   * @throws NoAnswerException if phoenix may be running and has not answered within the time limit
   * @throws RemoteException if no phoenix runs
   */
  public List<GroupStatus> groupStatus(Duration deadline, Duration time) throws RemoteException {
    return groupStatus(admin(deadline), RetryDeadline.of(time));
  }

  /** The status of its groups, with a phoenix and a time limit that a test may replace. */
  List<GroupStatus> groupStatus(PhoenixAdmin admin, RetryDeadline asking) throws RemoteException {
    while (true) {
      try {
        return admin.groupStatus();
      } catch (RemoteException e) {
        if (ConnectionRefusal.isProvenBy(e) || !RetryDeadline.isUnanswered(e)) {
          throw e;
        }
        boolean mayHang = e instanceof DeadlineExceededException;
        if ((!mayHang || asking.isExpired()) && hasCertainlyEnded()) {
          throw e; // the address may no longer belong to this computer
        }
        if (asking.isExpired()) {
          throw new NoAnswerException("phoenix at " + host + ":" + port, asking.timeout(), e);
        }
        asking.pause();
      }
    }
  }

  /** Whether no process can be the phoenix that owns the journal. */
  private boolean hasCertainlyEnded() {
    try {
      long owner = owner();
      return ProcessIdentity.find(owner).isEmpty() || !isPhoenix(owner);
    } catch (NoSuchFileException e) {
      return true; // no process ever owned it, or its process ended meanwhile
    } catch (IOException | NumberFormatException e) {
      return false;
    }
  }

  private long owner() throws IOException {
    return Long.parseLong(Files.readString(journal().resolve("phoenix.lock")).strip());
  }

  /** If processes cannot be inspected, each may be one. */
  private static boolean isPhoenix(long pid) throws IOException {
    Path command = Path.of("/proc", Long.toString(pid), "cmdline"); // ProcessHandle truncates it
    return !Files.exists(Path.of("/proc/self")) || Files.readString(command).contains(MAIN);
  }

  /**
   * Phoenix's administration interface.
   *
   * @throws ConnectException if no phoenix was ever started with this state
   * @throws AccessException if phoenix, or what listens on its port, is another user's
   */
  public PhoenixAdmin admin() throws RemoteException {
    return (PhoenixAdmin) system();
  }

  /**
   * The ID of the process that owns the journal in the state folder; empty if no process owns it,
   * or if the folder cannot be read.
   */
  public OptionalLong pid() {
    try {
      long pid = owner();
      return isPhoenix(pid) && ProcessHandle.of(pid).isPresent()
          ? OptionalLong.of(pid)
          : OptionalLong.empty();
    } catch (IOException | NumberFormatException e) {
      return OptionalLong.empty();
    }
  }

  /** The file with what the process prints. */
  public Path log() {
    return state.resolve("phoenix.log");
  }

  /**
   * Starts the process in a session of its own and waits until it answers. So neither Ctrl-C in the
   * terminal that starts it nor the end of that terminal ends the robots.
   *
   * @param timeout how long to wait
   * @throws IOException if a phoenix already answers, the state folder is open to other users, or
   *     the process cannot be started, ends or does not answer in time
   */
  public Process start(Duration timeout) throws IOException {
    requireOwnedByUser();
    if (isResponding()) {
      throw new IOException(
          "a phoenix already answers at " + host + ":" + port + "; use it, or name another port");
    }
    makeFolder();
    PermittedLaunchOptions.clear(state);
    PrivateFiles.makeFile(log());
    Process process =
        new ProcessBuilder(command())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.appendTo(log().toFile()))
            .start();
    process.getOutputStream().close();
    long end = System.nanoTime() + timeout.toNanos();
    while (!isResponding()) {
      if (!process.isAlive()) {
        throw new IOException(
            "phoenix ended at once (exit code " + process.exitValue() + "): " + lastError());
      }
      if (System.nanoTime() - end > 0) {
        process.destroyForcibly();
        throw new IOException(
            "phoenix did not answer within " + timeout.toSeconds() + " s; see " + log());
      }
      // A detached process does not signal that it is ready, so this polls.
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
    }
    return process;
  }

  private void makeFolder() throws IOException {
    try {
      PrivateFiles.requireFolder(state);
    } catch (FileSystemException e) {
      throw new IOException(
          "phoenix's folder "
              + state
              + " cannot be made ("
              + e
              + "); give this user the right, or phoenix another folder",
          e);
    }
  }

  /**
   * Ends phoenix and every group, and waits until no process listens at its address any more: a
   * timeout does not prove its end.
   *
   * @throws IOException if it refuses or does not end in time
   */
  public void shutdown(Duration timeout) throws IOException {
    long end = System.nanoTime() + timeout.toNanos();
    boolean isAccepted = false;
    while (mayAnswer()) {
      if (System.nanoTime() - end > 0) {
        throw new IOException("phoenix did not end within " + timeout.toSeconds() + " s");
      }
      if (!isAccepted) {
        try {
          system().shutdown();
          isAccepted = true;
        } catch (RemoteException e) {
          if (!RetryDeadline.isUnanswered(e)) {
            throw e;
          } // the call is repeated while phoenix runs
        }
      }
      LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
    }
  }

  private boolean mayAnswer() {
    try {
      List<GroupStatus> unused = admin().groupStatus();
      return true;
    } catch (RemoteException e) {
      return RetryDeadline.isUnanswered(e)
          && !ConnectionRefusal.isProvenBy(e)
          && !hasCertainlyEnded();
    }
  }

  private String lastError() throws IOException {
    String printed = Files.readString(log());
    int last = printed.lastIndexOf(Phoenix.CANNOT_START);
    return last < 0
        ? "see " + log()
        : printed.substring(last + Phoenix.CANNOT_START.length()).lines().findFirst().orElse("");
  }

  private List<String> command() {
    List<String> command = new ArrayList<>(DetachedCommand.prefix(System.getenv("PATH")));
    command.add(JvmCommand.java());
    command.addAll(JvmCommand.options());
    command.addAll(HeapOptions.of(List.of()));
    Path security = SecureProcess.folder(state);
    if (IdentityFolder.isJoined(security)) {
      command.add("-D" + SecureProcess.PROPERTY + "=" + security.toAbsolutePath());
    }
    command.add(MAIN);
    String resource = "phoenix.config";
    command.add(PhoenixProcess.class.getResource(resource).toString());
    override(command, "host", quote(host));
    override(command, "port", Integer.toString(port));
    override(command, "registryPort", Integer.toString(registryPort));
    override(command, "persistenceDirectory", quote(journal().toString()));
    override(command, "outputDirectory", quote(state.resolve("output").toString()));
    override(
        command,
        "permittedOptionsFiles",
        PermittedLaunchOptions.files(state).stream()
            .map(file -> quote(file.toString()))
            .collect(Collectors.joining(", ", "new String[] {", "}")));
    return command;
  }

  private static void override(List<String> command, String entry, String expression) {
    command.add("org.dfra.river.phoenix." + entry + "=" + expression);
  }

  /** A text as a Jini configuration writes it. */
  static String quote(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}
