package org.dfra.river.security.robot;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.regex.Pattern;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.ConfirmationRequests;
import org.dfra.core.policy.ConfirmationRequests.PendingConfirmation;
import org.dfra.text.PrintableText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The requests for confirmation of all processes of a robot, in a folder that they share: a file
 * for each request, which the process that was called writes and deletes, and beside it the answer.
 * Times are by the monotonic clock, which on Linux is the same for all processes of a computer.
 */
final class RequestFiles {

  private static final Logger LOG = LoggerFactory.getLogger(RequestFiles.class);

  private static final String REQUEST = ".request";
  private static final String ANSWER = ".answer";
  private static final String CONFIRMED = "confirmed ";
  private static final String REFUSED = "refused ";
  private static final Pattern ID = Pattern.compile("[a-z0-9]{1,16}");

  private static final long MAX_NANOS = TimeUnit.SECONDS.toNanos(ConfirmationRequests.KEPT_SECONDS);

  private final Path folder;
  private final LongSupplier nanos;

  /** Those of this process that have a file. Confined to the thread of {@link #exchange}. */
  private final Map<String, PendingConfirmation> written = new HashMap<>();

  /**
   * @param folder made when it is first written to
   * @param nanos the monotonic clock of the computer, in nanoseconds
   */
  RequestFiles(Path folder, LongSupplier nanos) {
    this.folder = folder;
    this.nanos = nanos;
  }

  private Path request(String id) {
    return folder.resolve(id + REQUEST);
  }

  private Path answer(String id) {
    return folder.resolve(id + ANSWER);
  }

  /**
   * Writes the requests of this process that are new, takes the answers, and deletes the files of
   * those that are over. For one thread.
   *
   * @return whether there are any
   */
  boolean exchange(ConfirmationRequests own) throws IOException {
    List<PendingConfirmation> pending = own.pending();
    for (PendingConfirmation each : pending) {
      if (!written.containsKey(each.id())) {
        PrivateFiles.requireFolder(folder);
        PrivateFiles.write(request(each.id()), text(each).getBytes(StandardCharsets.UTF_8));
        written.put(each.id(), each);
        LOG.info("Request {} waits for an operator: {}", each.id(), sentence(each));
      }
    }
    for (PendingConfirmation each : List.copyOf(written.values())) {
      Optional<String> answer = read(answer(each.id()));
      if (answer.isPresent()) {
        boolean isConfirmed = answer.get().startsWith(CONFIRMED);
        boolean isInTime = own.answer(each.id(), isConfirmed);
        LOG.info(
            "Request {} was {}{}: {}",
            each.id(),
            answer.get().strip(),
            isInTime ? "" : ", too late",
            sentence(each));
      }
      if (answer.isPresent() || !pending.contains(each)) {
        delete(each.id());
        written.remove(each.id());
      }
    }
    return !written.isEmpty();
  }

  private static String sentence(PendingConfirmation of) {
    return of.request().methodName()
        + (of.request().object().isEmpty() ? "" : " of " + of.request().object())
        + " by "
        + PrintableText.line(of.request().caller().toString());
  }

  private void delete(String id) throws IOException {
    Files.deleteIfExists(request(id)); // first: nobody answers it any more
    Files.deleteIfExists(answer(id));
  }

  private static String text(PendingConfirmation of) throws IOException {
    Properties all = new Properties();
    all.setProperty("robot", of.request().robot());
    all.setProperty("object", of.request().object());
    all.setProperty("method", of.request().methodName());
    all.setProperty("caller", of.request().caller().toString());
    all.setProperty("rule", of.rule());
    all.setProperty("end", Long.toString(of.end()));
    all.setProperty("process", Long.toString(ProcessHandle.current().pid()));
    StringWriter text = new StringWriter();
    all.store(text, null);
    return text.toString();
  }

  /** The requests of all processes that wait, the oldest first. For any process. */
  List<WaitingRequest> waiting() throws IOException {
    List<WaitingRequest> waiting = new ArrayList<>();
    if (!Files.isDirectory(folder)) {
      return waiting;
    }
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + REQUEST)) {
      for (Path each : files) {
        String name = String.valueOf(each.getFileName());
        String id = name.substring(0, name.length() - REQUEST.length());
        if (!Files.exists(answer(id))) {
          waiting(id).ifPresent(waiting::add);
        }
      }
    }
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + ANSWER)) {
      for (Path each : files) {
        String name = String.valueOf(each.getFileName());
        if (!Files.exists(request(name.substring(0, name.length() - ANSWER.length())))) {
          Files.deleteIfExists(each); // it came too late
        }
      }
    }
    waiting.sort(Comparator.comparingLong(WaitingRequest::secondsLeft));
    return waiting;
  }

  private Optional<WaitingRequest> waiting(String id) throws IOException {
    Optional<String> text = read(request(id));
    if (text.isEmpty()) {
      return Optional.empty(); // it has just ended
    }
    Properties all = new Properties();
    all.load(new StringReader(text.get()));
    long left;
    long process;
    try {
      left = Long.parseLong(all.getProperty("end", "")) - nanos.getAsLong();
      process = Long.parseLong(all.getProperty("process", ""));
    } catch (NumberFormatException e) {
      throw new IOException(request(id) + " is no request; delete it", e);
    }
    boolean isAlive = ProcessHandle.of(process).map(ProcessHandle::isAlive).orElse(false);
    if (!isAlive || left <= 0 || left > MAX_NANOS) { // of a process or of a computer that has ended
      delete(id);
      return Optional.empty();
    }
    return Optional.of(
        new WaitingRequest(
            id,
            all.getProperty("robot", ""),
            all.getProperty("object", ""),
            all.getProperty("method", ""),
            all.getProperty("caller", ""),
            all.getProperty("rule", ""),
            TimeUnit.NANOSECONDS.toSeconds(left)));
  }

  /**
   * Answers a request of any process.
   *
   * @param by who answers
   * @return false if no such request waits
   */
  boolean answer(String id, boolean isConfirmed, String by) throws IOException {
    return ID.matcher(id).matches()
        && waiting(id).isPresent()
        && PrivateFiles.writeNew(
            answer(id),
            (isConfirmed ? CONFIRMED : REFUSED) + "by " + PrintableText.line(by) + "\n");
  }

  private static Optional<String> read(Path file) throws IOException {
    try {
      return Optional.of(Files.readString(file));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    }
  }
}
