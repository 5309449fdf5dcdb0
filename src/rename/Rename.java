import com.sun.source.doctree.*;
import com.sun.source.tree.*;
import com.sun.source.util.*;
import com.sun.tools.javac.tree.JCTree;
import java.io.*;
import java.nio.charset.StandardCharsets;
import java.nio.file.*;
import java.util.*;
import java.util.function.*;
import java.util.regex.*;
import java.util.stream.*;
import javax.lang.model.element.*;
import javax.lang.model.type.*;
import javax.lang.model.util.*;
import javax.tools.*;

/**
 * Renames Java names by symbol. Usage: Rename ROOT CLASSPATH MAP.tsv [--write]
 * Reads all java files below ROOT that git lists. MAP: kind, old, new.
 *   type   a.b.Old        New | c.d.New
 *   nested a.b.Outer.Old  New
 *   package a.b           c.d          (prefix of packages below too: "a.b.*" -> "c.d.*")
 *   method a.b.T#m        n
 *   field|enum|component a.b.T#f  g
 *   param|local  a.b.T#m(p)   q
 * Writes edited files, moves those whose top-level type changed its name or package (git mv), prints what it did.
 */
public class Rename {
  static final Map<String, String> types = new LinkedHashMap<>(); // fqn -> new fqn
  static final Map<String, String> packages = new LinkedHashMap<>();
  static final Map<String, String> members = new LinkedHashMap<>(); // owner#name -> new
  static final Map<String, String> params = new LinkedHashMap<>(); // owner#method(param)
  static final Set<String> used = new TreeSet<>();

  record Edit(int start, int end, String text) {}

  static String simple(String fqn) { return fqn.substring(fqn.lastIndexOf('.') + 1); }
  static String qualifier(String fqn) { int i = fqn.lastIndexOf('.'); return i < 0 ? "" : fqn.substring(0, i); }

  public static void main(String[] args) throws Exception {
    Path root = Path.of(args[0]);
    String cp = args[1];
    boolean write = args.length > 3 && args[3].equals("--write");
    for (String line : Files.readAllLines(Path.of(args[2]))) {
      if (line.isBlank() || line.startsWith("#")) continue;
      String[] c = line.split("\t");
      String kind = c[0].trim(), old = c[1].trim(), now = c[2].trim();
      switch (kind) {
        case "type" -> types.put(old, now.contains(".") ? now : qualifier(old) + "." + now);
        case "nested" -> types.put(old, now.contains(".") ? now : qualifier(old) + "." + now);
        case "package" -> packages.put(old, now);
        case "method", "field", "enum", "component" -> members.put(old, now);
        case "param", "local" -> params.put(old, now);
        default -> { }
      }
    }
    Process git = new ProcessBuilder("git", "ls-files", "-z", "*.java").directory(root.toFile()).start();
    List<Path> files = new ArrayList<>();
    for (String f : new String(git.getInputStream().readAllBytes()).split("\0")) {
      Path p = root.resolve(f);
      if (Files.exists(p) && !p.endsWith("module-info.java")) files.add(p);
    }
    JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
    StandardJavaFileManager fm = javac.getStandardFileManager(null, null, StandardCharsets.UTF_8);
    // package-info and same-named types of several source roots: one task each group of roots without clashes
    List<Path> rest = files;
    Map<Path, TreeSet<Edit>> edits = new TreeMap<>();
    DiagnosticCollector<JavaFileObject> diags = new DiagnosticCollector<>();
    Map<String, Path> seen = new HashMap<>();
    List<Path> unit = new ArrayList<>();
    List<Path> infos = new ArrayList<>();
    for (Path f : rest) {
      if (f.endsWith("package-info.java")) {
        infos.add(f);
        continue;
      }
      String text = Files.readString(f);
      Matcher m = Pattern.compile("(?m)^package ([\\w.]+);").matcher(text);
      String fqn = (m.find() ? m.group(1) : "") + "." + f.getFileName();
      Path other = seen.put(fqn, f);
      if (other != null) System.out.println("TWICE " + fqn + " " + other + " " + f);
      else unit.add(f);
    }
    Set<String> infoSeen = new HashSet<>();
    for (Path f : infos) {
      Matcher m = Pattern.compile("(?m)^package ([\\w.]+);").matcher(Files.readString(f));
      if (m.find() && infoSeen.add(m.group(1))) unit.add(f); else System.out.println("TWICE package-info " + f);
    }
    List<String> options = List.of("-proc:none", "-cp", cp, "-Xmaxerrs", "50", "-nowarn", "-parameters");
    JavacTask task = (JavacTask) javac.getTask(null, fm, diags, options, null, fm.getJavaFileObjectsFromPaths(unit));
    List<CompilationUnitTree> units = new ArrayList<>();
    for (CompilationUnitTree u : task.parse()) units.add(u);
    task.analyze();
    for (Diagnostic<?> d : diags.getDiagnostics())
      if (d.getKind() == Diagnostic.Kind.ERROR) System.out.println("ERROR " + d);
    Trees trees = Trees.instance(task);
    DocTrees docs = DocTrees.instance(task);
    Names names = new Names(task.getElements(), task.getTypes());
    Map<Path, Path> moves = new LinkedHashMap<>();
    int n = 0;
    for (CompilationUnitTree u : units) {
      Path path = Path.of(u.getSourceFile().toUri());
      TreeSet<Edit> e = new TreeSet<>(Comparator.comparingInt(Edit::start).thenComparing(Edit::end).thenComparing(Edit::text));
      String src = u.getSourceFile().getCharContent(true).toString();
      new Scan(u, trees, docs, names, src, e).run();
      String moved = target(u, path, names);
      if (e.isEmpty() && moved == null) continue;
      edits.put(path, e);
      StringBuilder out = new StringBuilder(src);
      int last = Integer.MAX_VALUE;
      for (Edit x : e.descendingSet()) {
        if (x.end > last) { System.out.println("OVERLAP " + path + " " + x); continue; }
        out.replace(x.start, x.end, x.text);
        last = x.start;
        n++;
      }
      if (write) Files.writeString(path, out);
      if (moved != null) moves.put(path, path.resolve(moved).normalize());
    }
    for (var m : moves.entrySet()) {
      System.out.println("MOVE " + root.relativize(m.getKey()) + " " + root.relativize(m.getValue()));
      if (write) {
        Files.createDirectories(m.getValue().getParent());
        int rc = new ProcessBuilder("git", "mv", m.getKey().toString(), m.getValue().toString()).directory(root.toFile()).inheritIO().start().waitFor();
        if (rc != 0) System.out.println("MOVE FAILED");
      }
    }
    System.out.println(n + " edits in " + edits.size() + " files, " + moves.size() + " moved");
    for (var map : List.of(types, packages, members, params))
      for (String key : map.keySet()) if (!used.contains(key)) System.out.println("UNUSED " + key);
  }

  /** Where the file goes, relative to itself; null: stays. */
  static String target(CompilationUnitTree u, Path path, Names names) {
    String pkg = u.getPackageName() == null ? "" : u.getPackageName().toString();
    String base = path.getFileName().toString().replace(".java", "");
    String now = names.fqn(pkg + "." + base, pkg);
    if (base.equals("package-info")) now = names.pkg(pkg) + ".package-info";
    if (now.equals(pkg + "." + base)) return null;
    int depth = pkg.split("\\.").length;
    return "../" + "../".repeat(depth) + now.replace('.', '/') + ".java";
  }

  static final class Names {
    final Elements elements;
    final Types typeUtils;
    final Map<Element, Optional<String>> cache = new IdentityHashMap<>();
    Names(Elements e, Types t) { elements = e; typeUtils = t; }

    String pkg(String p) {
      String d = packages.get(p);
      if (d != null) { used.add(p); return d; }
      for (var x : packages.entrySet())
        if (x.getKey().endsWith(".*")) {
          String from = x.getKey().substring(0, x.getKey().length() - 2);
          if (p.equals(from) || p.startsWith(from + ".")) {
            used.add(x.getKey());
            return x.getValue().replace(".*", "") + p.substring(from.length());
          }
        }
      return p;
    }

    String fqn(String fqn, String pkg) {
      String t = types.get(fqn);
      if (t != null) {
        used.add(fqn);
        return qualifier(t).equals(pkg) ? pkg(pkg) + "." + simple(t) : t;
      }
      return pkg(pkg) + fqn.substring(pkg.length());
    }

    String newPackage(TypeElement top) {
      String pkg = elements.getPackageOf(top).getQualifiedName().toString();
      return qualifier(fqn(top.getQualifiedName().toString(), pkg));
    }

    static TypeElement top(Element e) {
      while (e != null && !(e.getEnclosingElement() instanceof PackageElement)) e = e.getEnclosingElement();
      return e instanceof TypeElement t ? t : null;
    }

    /** The new simple name; null: unchanged. */
    String rename(Element e) {
      if (e == null) return null;
      return cache.computeIfAbsent(e, x -> Optional.ofNullable(find(x))).orElse(null);
    }

    private String find(Element e) {
      String name = e.getSimpleName().toString();
      switch (e.getKind()) {
        case CLASS, INTERFACE, ENUM, RECORD, ANNOTATION_TYPE -> {
          String q = ((TypeElement) e).getQualifiedName().toString();
          if (q.isEmpty()) return null;
          String t = types.get(q);
          if (t != null) { used.add(q); return simple(t).equals(name) ? null : simple(t); }
          return null;
        }
        case CONSTRUCTOR -> { return rename(e.getEnclosingElement()); }
        case METHOD -> { return method((ExecutableElement) e); }
        case FIELD, ENUM_CONSTANT, RECORD_COMPONENT -> {
          String m = member(e);
          if (m != null) return m;
          if (e.getEnclosingElement() instanceof TypeElement t && t.getKind() == ElementKind.RECORD && !e.getModifiers().contains(Modifier.STATIC))
            return accessor(t, name);
          return null;
        }
        case PARAMETER, LOCAL_VARIABLE, EXCEPTION_PARAMETER, RESOURCE_VARIABLE, BINDING_VARIABLE -> {
          Element m = e.getEnclosingElement();
          if (m instanceof ExecutableElement x) {
            if (!(x.getEnclosingElement() instanceof TypeElement t)) return null;
            String key = t.getQualifiedName() + "#" + (x.getKind() == ElementKind.CONSTRUCTOR ? t.getSimpleName() : x.getSimpleName()) + "(" + name + ")";
            String p = params.get(key);
            if (p == null && x.getKind() == ElementKind.CONSTRUCTOR) p = params.get(key = t.getQualifiedName() + "#<init>(" + name + ")");
            if (p != null) { used.add(key); return p; }
            if (x.getKind() == ElementKind.CONSTRUCTOR && t.getKind() == ElementKind.RECORD) {
              List<? extends RecordComponentElement> cs = t.getRecordComponents();
              if (cs.size() == x.getParameters().size()
                  && IntStream.range(0, cs.size()).allMatch(i -> cs.get(i).getSimpleName().equals(x.getParameters().get(i).getSimpleName())))
                for (RecordComponentElement c : cs) if (c.getSimpleName().contentEquals(name)) return rename(c);
            }
          }
          return null;
        }
        default -> { return null; }
      }
    }

    private String member(Element e) {
      if (!(e.getEnclosingElement() instanceof TypeElement t)) return null;
      String key = t.getQualifiedName() + "#" + e.getSimpleName();
      String m = members.get(key);
      if (m != null) used.add(key);
      return m;
    }

    private String accessor(TypeElement record, String name) {
      for (ExecutableElement m : ElementFilter.methodsIn(record.getEnclosedElements()))
        if (m.getSimpleName().contentEquals(name) && m.getParameters().isEmpty()) return method(m);
      return null;
    }

    private String method(ExecutableElement m) {
      String direct = member(m);
      if (direct != null) return direct;
      if (!(m.getEnclosingElement() instanceof TypeElement owner)) return null;
      if (m.getModifiers().contains(Modifier.STATIC)) return null;
      for (TypeElement s : supers(owner, new LinkedHashSet<>()))
        for (ExecutableElement x : ElementFilter.methodsIn(s.getEnclosedElements()))
          if (x.getSimpleName().equals(m.getSimpleName()) && elements.overrides(m, x, owner)) {
            String k = member(x);
            if (k != null) return k;
          }
      return null;
    }

    private Set<TypeElement> supers(TypeElement t, Set<TypeElement> into) {
      for (TypeMirror s : typeUtils.directSupertypes(t.asType()))
        if (s instanceof DeclaredType d && d.asElement() instanceof TypeElement e && into.add(e)) supers(e, into);
      return into;
    }
  }

  static final class Scan extends TreePathScanner<Void, Void> {
    final CompilationUnitTree unit; final Trees trees; final DocTrees docs; final Names names; final String src; final Set<Edit> edits;
    final SourcePositions positions;
    final String oldPackage, newPackage;
    final Set<String> imported = new HashSet<>();
    final Set<String> needed = new TreeSet<>();
    final Set<String> declared = new HashSet<>();

    Scan(CompilationUnitTree u, Trees t, DocTrees d, Names n, String s, Set<Edit> e) {
      unit = u; trees = t; docs = d; names = n; src = s; edits = e; positions = t.getSourcePositions();
      oldPackage = u.getPackageName() == null ? "" : u.getPackageName().toString();
      String np = names.pkg(oldPackage);
      for (Tree x : u.getTypeDecls())
        if (x instanceof ClassTree c) np = qualifier(names.fqn(oldPackage + "." + c.getSimpleName(), oldPackage));
      newPackage = np;
    }

    void run() {
      scan(unit, null);
      for (String q : needed) {
        int at = (int) (unit.getImports().isEmpty() ? positions.getEndPosition(unit, unit.getPackage()) : positions.getEndPosition(unit, unit.getImports().get(0)));
        edits.add(new Edit(at, at, "\nimport " + q + ";"));
      }
    }

    int start(Tree t) { return (int) positions.getStartPosition(unit, t); }
    int end(Tree t) { return (int) positions.getEndPosition(unit, t); }

    void name(int at, String old, String now) {
      if (now == null || now.equals(old) || at < 0) return;
      if (!src.startsWith(old, at)) { System.out.println("MISPLACED " + unit.getSourceFile().getName() + " " + old + " -> " + now + " at " + at + ": " + src.substring(at, Math.min(at + 20, src.length()))); return; }
      edits.add(new Edit(at, at + old.length(), now));
    }

    @Override public Void visitPackage(PackageTree t, Void v) {
      if (!newPackage.equals(oldPackage)) edits.add(new Edit(start(t.getPackageName()), end(t.getPackageName()), newPackage));
      scan(t.getAnnotations(), v);
      doc();
      return null;
    }

    @Override public Void visitImport(ImportTree t, Void v) {
      Tree q = t.getQualifiedIdentifier();
      String text = q.toString();
      Element e = trees.getElement(new TreePath(getCurrentPath(), q));
      String now = null;
      if (t.isStatic()) {
        MemberSelectTree ms = (MemberSelectTree) q;
        Element owner = trees.getElement(new TreePath(new TreePath(getCurrentPath(), q), ms.getExpression()));
        if (owner instanceof TypeElement o) {
          String member = ms.getIdentifier().toString();
          String renamed = null;
          for (Element x : names.elements.getAllMembers(o)) if (x.getSimpleName().contentEquals(member)) { renamed = names.rename(x); if (renamed != null) break; }
          now = newFqn(o) + "." + (renamed == null ? member : renamed);
        }
      } else if (e instanceof TypeElement te) {
        now = newFqn(te);
        imported.add(now);
        String p = names.elements.getPackageOf(te).getQualifiedName().toString();
      } else if (text.endsWith(".*")) {
        now = names.pkg(text.substring(0, text.length() - 2)) + ".*";
      }
      if (now != null && !now.equals(text)) edits.add(new Edit(start(q), end(q), now));
      return null;
    }

    String newFqn(TypeElement t) {
      Element outer = t.getEnclosingElement();
      String n = names.rename(t);
      if (outer instanceof TypeElement o) return newFqn(o) + "." + (n == null ? t.getSimpleName() : n);
      String pkg = names.elements.getPackageOf(t).getQualifiedName().toString();
      return names.fqn(t.getQualifiedName().toString(), pkg);
    }

    @Override public Void visitIdentifier(IdentifierTree t, Void v) {
      Element e = trees.getElement(getCurrentPath());
      name(start(t), t.getName().toString(), names.rename(e));
      need(e);
      return super.visitIdentifier(t, v);
    }

    void need(Element e) {
      if (!(e instanceof TypeElement te) || !(te.getEnclosingElement() instanceof PackageElement p)) return;
      String op = p.getQualifiedName().toString();
      if (!op.equals(oldPackage)) {
        return; // imported already (import is rewritten) or java.lang
      }
      String q = newFqn(te);
      if (!qualifier(q).equals(newPackage)) needed.add(q);
    }

    @Override public Void visitMemberSelect(MemberSelectTree t, Void v) {
      Element e = trees.getElement(getCurrentPath());
      String n = t.getIdentifier().toString();
      if (e instanceof TypeElement te && te.getEnclosingElement() instanceof PackageElement) {
        String now = newFqn(te);
        String old = te.getQualifiedName().toString();
        if (!now.equals(old) && src.startsWith(old, start(t))) { edits.add(new Edit(start(t), end(t), now)); return null; }
      }
      name(end(t) - n.length(), n, names.rename(e));
      return super.visitMemberSelect(t, v);
    }

    @Override public Void visitMemberReference(MemberReferenceTree t, Void v) {
      Element e = trees.getElement(getCurrentPath());
      String n = t.getName().toString();
      if (t.getMode() == MemberReferenceTree.ReferenceMode.INVOKE) name(end(t) - n.length(), n, names.rename(e));
      return super.visitMemberReference(t, v);
    }

    @Override public Void visitClass(ClassTree t, Void v) {
      Element e = trees.getElement(getCurrentPath());
      String n = t.getSimpleName().toString();
      if (!n.isEmpty() && names.rename(e) != null) {
        int from = end(t.getModifiers());
        if (from < 0) from = start(t);
        Matcher m = Pattern.compile("\\b(class|interface|enum|record)\\s+(" + n + ")\\b").matcher(src);
        if (m.find(from)) name(m.start(2), n, names.rename(e));
      }
      doc();
      return super.visitClass(t, v);
    }

    @Override public Void visitMethod(MethodTree t, Void v) {
      Element e = trees.getElement(getCurrentPath());
      JCTree.JCMethodDecl d = (JCTree.JCMethodDecl) t;
      String n = t.getName().toString();
      boolean generated = e != null && (((com.sun.tools.javac.code.Symbol) e).flags() & (com.sun.tools.javac.code.Flags.GENERATEDCONSTR | com.sun.tools.javac.code.Flags.GENERATED_MEMBER)) != 0 && end(t) < 0;
      if (n.equals("<init>")) {
        n = e == null ? "" : e.getEnclosingElement().getSimpleName().toString();
        if (src.startsWith(n, d.pos)) name(d.pos, n, names.rename(e));
      } else if (src.startsWith(n, d.pos)) name(d.pos, n, names.rename(e));
      doc();
      return super.visitMethod(t, v);
    }

    @Override public Void visitVariable(VariableTree t, Void v) {
      Element e = trees.getElement(getCurrentPath());
      JCTree.JCVariableDecl d = (JCTree.JCVariableDecl) t;
      String n = t.getName().toString();
      if (!n.isEmpty() && src.startsWith(n, d.pos)) name(d.pos, n, names.rename(e));
      doc();
      return super.visitVariable(t, v);
    }

    // Javadoc
    void doc() {
      TreePath path = getCurrentPath();
      DocCommentTree c = docs.getDocCommentTree(path);
      if (c == null) return;
      DocSourcePositions dp = docs.getSourcePositions();
      Element owner = trees.getElement(path);
      new DocTreePathScanner<Void, Void>() {
        @Override public Void visitReference(ReferenceTree r, Void v) {
          int s = (int) dp.getStartPosition(unit, c, r), en = (int) dp.getEndPosition(unit, c, r);
          if (s < 0 || en < 0) return null;
          String sig = src.substring(s, en);
          String now = signature(sig, docs.getElement(getCurrentPath()));
          if (!now.equals(sig)) edits.add(new Edit(s, en, now));
          return null;
        }
        @Override public Void visitParam(ParamTree p, Void v) {
          if (!p.isTypeParameter()) {
            String n = p.getName().getName().toString(), now = null;
            if (owner instanceof ExecutableElement x) {
              for (VariableElement q : x.getParameters()) if (q.getSimpleName().contentEquals(n)) now = names.rename(q);
            } else if (owner instanceof TypeElement te && te.getKind() == ElementKind.RECORD)
              for (RecordComponentElement q : te.getRecordComponents()) if (q.getSimpleName().contentEquals(n)) now = names.rename(q);
            int s = (int) dp.getStartPosition(unit, c, p.getName());
            if (now != null) name(s, n, now);
          }
          return super.visitParam(p, v);
        }
      }.scan(new DocTreePath(path, c), null);
    }

    String signature(String sig, Element target) {
      String type, rest = "";
      int hash = sig.indexOf('#');
      type = hash < 0 ? sig : sig.substring(0, hash);
      if (hash >= 0) rest = sig.substring(hash);
      TypeElement te = null;
      if (target instanceof TypeElement x) te = x; else if (target != null && target.getEnclosingElement() instanceof TypeElement y) te = y;
      String t = typeText(type, te);
      if (hash >= 0) {
        Matcher m = Pattern.compile("#(\\w+)(\\(.*\\))?", Pattern.DOTALL).matcher(rest);
        if (m.matches()) {
          String now = names.rename(target);
          String args = m.group(2) == null ? "" : m.group(2);
          Matcher a = Pattern.compile("[A-Z]\\w*(\\.[A-Z]\\w*)*").matcher(args);
          args = a.replaceAll(g -> Matcher.quoteReplacement(typeText(g.group(), null)));
          rest = "#" + (now == null || target instanceof TypeElement ? m.group(1) : now) + args;
        }
      }
      return t + rest;
    }

    /** By text: the type's name as it was written, whose element may be a subtype of te. */
    String typeText(String text, TypeElement te) {
      if (text.isEmpty()) return text;
      if (te != null && te.getQualifiedName().toString().endsWith(text)) {
        String now = newFqn(te);
        if (te.getQualifiedName().contentEquals(text)) return now;
        int parts = text.split("\\.").length;
        String[] p = now.split("\\.");
        String s = String.join(".", Arrays.copyOfRange(p, p.length - parts, p.length));
        if (text.indexOf('.') < 0) need(te);
        return s;
      }
      String first = text.split("\\.")[0];
      for (ImportTree i : unit.getImports()) {
        String q = i.getQualifiedIdentifier().toString();
        if (!i.isStatic() && q.endsWith("." + first)) {
          TypeElement x = names.elements.getTypeElement(q + text.substring(first.length()));
          return x == null ? text : typeTextOf(x, text);
        }
      }
      TypeElement x = names.elements.getTypeElement(oldPackage + "." + text);
      if (x == null) x = names.elements.getTypeElement(text);
      return x == null ? text : typeTextOf(x, text);
    }

    String typeTextOf(TypeElement x, String text) {
      String now = newFqn(x);
      if (x.getQualifiedName().contentEquals(text)) return now;
      int parts = text.split("\\.").length;
      String[] p = now.split("\\.");
      if (text.indexOf('.') < 0) need(x);
      return String.join(".", Arrays.copyOfRange(p, p.length - parts, p.length));
    }
  }
}
