package org.dfra.river.security.news;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dfra.core.audit.AuditHead;
import org.dfra.core.audit.HeadStore;
import org.dfra.core.audit.HeadStore.Outcome;
import org.dfra.core.audit.KeptHead;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.security.news.TeamNews.SignedHead;
import org.dfra.river.security.news.TeamNews.SignedHeads;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The ends of audit trails in a state folder: those of the own processes, which others get, and
 * those of other members. All processes of a robot share them. Thread-safe, also between processes.
 */
public final class HeadFiles {

  private static final Logger LOG = LoggerFactory.getLogger(HeadFiles.class);

  private static final String FOLDER = "heads";
  private static final String KEPT = "kept.jsonl";
  private static final String LOCK = "kept.lock";
  private static final String OWN = "own";
  private static final String SUFFIX = ".jsonl";
  private static final int MAX_CERTIFICATE = 8 * 1024;

  /** A lock of a file excludes other processes only. */
  private static final Object THIS_PROCESS = new Object();

  private final Path folder;
  private final TeamIdentity identity;
  private final InstantSource clock;

  /**
   * @param state folder of the process
   * @param identity says who is a member
   * @param clock for the times of receipt
   */
  HeadFiles(Path state, TeamIdentity identity, InstantSource clock) {
    this.folder = state.resolve(FOLDER);
    this.identity = identity;
    this.clock = clock;
  }

  /** The file with the heads of other members that a state folder keeps. */
  public static Path kept(Path state) {
    return state.resolve(FOLDER).resolve(KEPT);
  }

  /** Writes the end of this process's trail, for the processes that give it to others. */
  void writeOwn(KeptHead head) throws IOException {
    PrivateFiles.requireFolder(folder);
    Path file = folder.resolve(OWN).resolve(head.head().stream() + SUFFIX);
    Outcome unused = HeadStore.open(file, clock).keep(head.head(), head.certificate());
  }

  /** The ends of the trails of all own processes that have signed with the present certificate. */
  SignedHeads own() throws IOException {
    X509Certificate certificate = identity.certificate();
    List<SignedHead> heads = new ArrayList<>();
    for (Path file : ownFiles()) {
      List<KeptHead> stored = HeadStore.read(file);
      if (!stored.isEmpty() && heads.size() < HeadStore.MOST_STREAMS) {
        KeptHead last = stored.get(stored.size() - 1);
        if (last.certificate().equals(certificate)) {
          heads.add(signed(last.head()));
        }
      }
    }
    try {
      return new SignedHeads(certificate.getEncoded(), heads);
    } catch (CertificateException e) {
      throw new IOException("the own certificate cannot be encoded", e);
    }
  }

  private List<Path> ownFiles() throws IOException {
    Path own = folder.resolve(OWN);
    if (!Files.isDirectory(own)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(own)) {
      return files.filter(each -> each.toString().endsWith(SUFFIX)).sorted().toList();
    }
  }

  private static SignedHead signed(AuditHead head) {
    return new SignedHead(
        head.stream(), head.number(), head.hash(), head.time().toEpochMilli(), head.signature());
  }

  /**
   * Keeps the heads of another member.
   *
   * @throws IOException if they are not signed by a member, are too many, or cannot be stored
   */
  void take(SignedHeads offered) throws IOException {
    if (offered.heads().size() > HeadStore.MOST_STREAMS) {
      throw new IOException(
          offered.heads().size()
              + " heads of audit trails were offered, at most "
              + HeadStore.MOST_STREAMS
              + " are taken");
    }
    X509Certificate certificate = certificate(offered.certificate());
    List<AuditHead> heads = new ArrayList<>();
    try {
      for (SignedHead each : offered.heads()) {
        Instant time = Instant.ofEpochMilli(each.timeMillis());
        heads.add(new AuditHead(each.stream(), each.number(), each.hash(), time, each.signature()));
      }
    } catch (IllegalArgumentException | DateTimeException e) {
      throw new IOException(e.getMessage(), e);
    }
    if (!heads.isEmpty()) {
      keep(heads, certificate);
    }
  }

  private X509Certificate certificate(byte[] encoded) throws IOException {
    if (encoded.length > MAX_CERTIFICATE) {
      throw new IOException("a certificate of " + encoded.length + " bytes was offered");
    }
    try {
      X509Certificate certificate =
          (X509Certificate)
              CertificateFactory.getInstance("X.509")
                  .generateCertificate(new ByteArrayInputStream(encoded));
      identity.requireMember(certificate);
      return certificate;
    } catch (CertificateException e) {
      throw new IOException("the heads of audit trails are refused: " + e.getMessage(), e);
    }
  }

  private void keep(List<AuditHead> heads, X509Certificate certificate) throws IOException {
    PrivateFiles.requireFolder(folder);
    Path lock = folder.resolve(LOCK);
    PrivateFiles.makeFile(lock);
    synchronized (THIS_PROCESS) {
      try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE);
          FileLock unused = channel.lock()) {
        List<Outcome> outcomes =
            HeadStore.open(folder.resolve(KEPT), clock).keep(heads, certificate);
        for (int i = 0; i < outcomes.size(); i++) {
          report(outcomes.get(i), KeptHead.of(heads.get(i), certificate));
        }
      }
    }
  }

  private void report(Outcome outcome, KeptHead head) throws IOException {
    switch (outcome) {
      case CONTRADICTION ->
          LOG.error(
              "{} has signed two different lines with number {} of its audit trail {}; see audit"
                  + " verify, and {}.",
              head.member(),
              head.head().number(),
              head.head().stream(),
              folder.resolve(KEPT));
      case NOT_SIGNED ->
          throw new IOException(
              head.member() + " has not signed the head of stream " + head.head().stream());
      case FULL ->
          LOG.warn(
              "The end of the audit trail {} of {} is not kept: there are too many.",
              head.head().stream(),
              head.member());
      default -> {
        // as usual
      }
    }
  }

  /** When heads of a member were received last; empty if none are kept. */
  Optional<Instant> lastReceived(String member) throws IOException {
    Path file = folder.resolve(KEPT);
    return Files.exists(file) ? HeadStore.open(file, clock).lastReceived(member) : Optional.empty();
  }

  /** Whether heads of a member were received within a time. */
  boolean isRecent(String member, Duration within) throws IOException {
    Instant now = clock.instant();
    return lastReceived(member)
        .filter(at -> !at.isAfter(now) && at.plus(within).isAfter(now))
        .isPresent();
  }

  /** The kept heads of a member. */
  List<KeptHead> kept(String member) throws IOException {
    Path file = folder.resolve(KEPT);
    return Files.exists(file)
        ? HeadStore.read(file).stream()
            .filter(each -> each.member().toString().equals(member))
            .toList()
        : List.of();
  }
}
