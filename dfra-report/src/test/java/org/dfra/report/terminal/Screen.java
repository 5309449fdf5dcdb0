package org.dfra.report.terminal;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A terminal without an edge, for tests: it knows how to go up and to clear what is below, and
 * refuses whatever else a program may ask of it.
 */
public final class Screen {

  private static final Pattern PIECE =
      Pattern.compile("\u001b\\[(\\??\\d*)([A-Za-z])|\r?\n|[^\u001b\r\n]+");

  private final List<StringBuilder> lines = new ArrayList<>(List.of(new StringBuilder()));
  private int row;

  /** Shows what is printed. */
  public void print(String text) {
    Matcher pieces = PIECE.matcher(text);
    int end = 0;
    while (pieces.find()) {
      if (pieces.start() != end) {
        throw new IllegalArgumentException("not understood: " + text.substring(end));
      }
      end = pieces.end();
      take(pieces);
    }
  }

  private void take(Matcher piece) {
    if (piece.group(2) == null) {
      if (piece.group().endsWith("\n")) {
        row++;
        if (row == lines.size()) {
          lines.add(new StringBuilder());
        }
      } else {
        lines.get(row).append(piece.group());
      }
      return;
    }
    switch (piece.group(2)) {
      case "A" -> row -= Integer.parseInt(piece.group(1));
      case "J" -> {
        lines.subList(row, lines.size()).clear();
        lines.add(new StringBuilder());
      }
      case "h", "l" -> {} // how it goes on at an edge that there is not
      default -> throw new IllegalArgumentException("not understood: " + piece.group());
    }
  }

  /** Is made so many columns wide: lines that do not fit any more go on in the next row. */
  public void narrow(int columns) {
    List<StringBuilder> folded = new ArrayList<>();
    int at = row;
    for (int i = 0; i < lines.size(); i++) {
      if (i == row) {
        at = folded.size();
      }
      String left = lines.get(i).toString();
      do {
        String piece = left.substring(0, Math.min(columns, left.length()));
        folded.add(new StringBuilder(piece));
        left = left.substring(piece.length());
      } while (!left.isEmpty());
    }
    lines.clear();
    lines.addAll(folded);
    row = at;
  }

  /** What it shows; not the empty line that the cursor is in. */
  public List<String> lines() {
    List<String> all = lines.stream().map(StringBuilder::toString).toList();
    return all.get(all.size() - 1).isEmpty() ? all.subList(0, all.size() - 1) : all;
  }
}
