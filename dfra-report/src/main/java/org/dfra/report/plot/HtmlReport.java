package org.dfra.report.plot;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import org.dfra.text.PrintableText;

/**
 * A report in one self-contained file without scripts: text, tables, and pages as inline SVG. All
 * text is plain and is escaped. Confined to one thread.
 */
public final class HtmlReport {

  private static final String STYLE =
      """
      body { font: 16px/1.5 sans-serif; color: #222; max-width: 1200px; margin: 2em auto; padding: 0 1em; }
      h1, h2 { line-height: 1.25; }
      p, figcaption { max-width: 50em; }
      table { border-collapse: collapse; margin: 1em 0; }
      th, td { border: 1px solid #ccc; padding: 0.25em 0.75em; text-align: left; vertical-align: top; }
      th { background: #f3f3f3; }
      figure { margin: 1.5em 0; }
      figure svg { display: block; width: 100%; height: auto; }
      figcaption { color: #555; }
      td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
      .verdict { font-weight: bold; padding: 0.5em 1em; border-left: 6px solid; }
      .met { color: #00573f; border-color: #009e73; background: #eef8f4; }
      .missed { color: #8a3c00; border-color: #d55e00; background: #fdf2ea; }
      """;

  private final StringBuilder body = new StringBuilder();
  private final String title;
  private int figures;

  public HtmlReport(String title) {
    this.title = title;
  }

  /** Starts a section. */
  public HtmlReport heading(String text) {
    return element("h2", text);
  }

  /**
   * Adds the verdict at the top.
   *
   * @param isWell whether the run passed
   */
  public HtmlReport verdict(boolean isWell, String text) {
    body.append("<p class=\"verdict ").append(isWell ? "met" : "missed").append("\">");
    body.append(escaped(unbroken(text))).append("</p>\n");
    return this;
  }

  /** Adds a paragraph. */
  public HtmlReport paragraph(String text) {
    return element("p", text);
  }

  private HtmlReport element(String name, String text) {
    body.append('<').append(name).append('>');
    body.append(escaped(unbroken(text))).append("</").append(name).append(">\n");
    return this;
  }

  /**
   * Adds a table.
   *
   * @param headings of the columns
   * @param rows each with as many cells
   */
  public HtmlReport table(List<String> headings, List<List<String>> rows) {
    for (List<String> row : rows) {
      if (row.size() != headings.size()) {
        throw new IllegalArgumentException(
            row.size() + " cells in a table of " + headings.size() + " columns");
      }
    }
    List<Boolean> columns = new ArrayList<>();
    for (int i = 0; i < headings.size(); i++) {
      int column = i;
      columns.add(Numerals.areNumbers(rows.stream().map(row -> row.get(column)).toList()));
    }
    body.append("<table>\n<thead>");
    row("th", headings, columns);
    body.append("</thead>\n<tbody>\n");
    rows.forEach(row -> row("td", row, columns));
    body.append("</tbody>\n</table>\n");
    return this;
  }

  /**
   * @param areNumbers for each column whether it is right-aligned
   */
  private void row(String cell, List<String> texts, List<Boolean> areNumbers) {
    body.append("<tr>");
    for (int i = 0; i < texts.size(); i++) {
      body.append('<').append(cell).append(areNumbers.get(i) ? " class=\"n\">" : ">");
      body.append(escaped(unbroken(texts.get(i))));
      body.append("</").append(cell).append('>');
    }
    body.append("</tr>\n");
  }

  /**
   * Adds the page in its current state.
   *
   * @param caption description of its content; empty for none
   * @throws NoFontException if no font is installed
   */
  public HtmlReport figure(Page page, String caption) {
    return add(painted(page), caption);
  }

  /**
   * Adds the page and also writes the image to an SVG file. It is painted once.
   *
   * @throws NoFontException if no font is installed
   */
  public HtmlReport figure(Page page, String caption, Path svg) throws IOException {
    String picture = painted(page);
    Page.write(picture, svg);
    return add(picture, caption);
  }

  private String painted(Page page) {
    figures++;
    return page.element("figure" + figures + "-");
  }

  private HtmlReport add(String picture, String caption) {
    body.append("<figure>\n").append(picture);
    if (!caption.isEmpty()) {
      element("figcaption", caption);
    }
    body.append("</figure>\n");
    return this;
  }

  /**
   * Adds an image.
   *
   * @param data encoded, and embedded in the document
   * @param mediaType of the data: {@code image/png}
   * @param caption description of its content
   */
  public HtmlReport image(byte[] data, String mediaType, String caption) {
    body.append("<figure>\n<img src=\"data:")
        .append(escaped(PrintableText.name(mediaType)))
        .append(";base64,")
        .append(Base64.getEncoder().encodeToString(data))
        .append("\" alt=\"")
        .append(escaped(PrintableText.lines(caption)))
        .append("\">\n");
    element("figcaption", caption);
    body.append("</figure>\n");
    return this;
  }

  /** The whole document. */
  public String html() {
    return """
        <!DOCTYPE html>
        <html lang="en">
        <head>
        <meta charset="utf-8">
        <meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
        <meta name="viewport" content="width=device-width, initial-scale=1">
        <title>%1$s</title>
        <style>
        %2$s</style>
        </head>
        <body>
        <h1>%1$s</h1>
        %3$s</body>
        </html>
        """
        .formatted(escaped(PrintableText.name(title)), STYLE, body);
  }

  /** Writes the whole document to a file. */
  public void write(Path file) throws IOException {
    Files.writeString(file, html(), StandardCharsets.UTF_8);
  }

  private static String unbroken(String text) {
    return Numerals.unbroken(PrintableText.lines(text));
  }

  /** Escapes a text that is {@linkplain PrintableText printable}. */
  private static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
