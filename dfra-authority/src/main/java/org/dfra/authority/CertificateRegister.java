package org.dfra.authority;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.dfra.core.host.PrivateFiles;

/**
 * The register of all certificates that the authority has issued: a file with a line of JSON for
 * each. Each change replaces the file, atomically.
 */
final class CertificateRegister {

  private static final ObjectMapper JSON = new ObjectMapper();

  private final Path file;

  CertificateRegister(Path file) {
    this.file = file;
  }

  /**
   * All of them, in the order in which they were issued.
   *
   * @throws AuthorityException if a line is not one of a register
   */
  List<IssuedCertificate> all() throws IOException {
    List<IssuedCertificate> all = new ArrayList<>();
    int number = 0;
    for (String line : Files.readAllLines(file)) {
      number++;
      try {
        all.add(JSON.readValue(line, IssuedCertificate.class));
      } catch (JsonProcessingException e) {
        throw new AuthorityException(
            file
                + ":"
                + number
                + ": this line is no certificate ("
                + e.getOriginalMessage()
                + "); restore the file from a copy",
            e);
      }
    }
    return all;
  }

  void add(IssuedCertificate issued) throws IOException {
    List<IssuedCertificate> all = all();
    all.add(issued);
    write(all);
  }

  /**
   * Marks certificates as revoked, also expired ones: a member whose certificate has expired may
   * still stop robots, and a revoked one may not.
   *
   * @return those that were not revoked before
   */
  List<IssuedCertificate> revoke(Predicate<IssuedCertificate> which, Instant now, String reason)
      throws IOException {
    List<IssuedCertificate> all = all();
    List<IssuedCertificate> revoked = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      IssuedCertificate each = all.get(i);
      if (each.revoked() == null && which.test(each)) {
        all.set(i, each.revoked(now, reason));
        revoked.add(all.get(i));
      }
    }
    if (!revoked.isEmpty()) {
      write(all);
    }
    return revoked;
  }

  private void write(List<IssuedCertificate> all) throws IOException {
    StringBuilder text = new StringBuilder();
    for (IssuedCertificate each : all) {
      text.append(JSON.writeValueAsString(each)).append('\n');
    }
    PrivateFiles.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
  }
}
