/* SPDX-License-Identifier: GPL-3.0-or-later
**
** system_windows.c - the operating system, for Windows.
*/
#include "system.h"

#ifdef _WIN32

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST_COMMAND 1000 /* characters */

/* The temporary file that a signal must remove; null if there is none. */
static wchar_t *volatile at_work;
static volatile sig_atomic_t caught;
static UINT old_page; /* of the console */

/* ----------------------------------------------------------------------------------------- errors, text */

/* Set errno from the error of the last call. */
static int fail(void)
{
    switch (GetLastError()) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
        errno = ENOENT;
        break;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_WRITE_PROTECT:
        errno = EACCES;
        break;
    case ERROR_NOT_ENOUGH_MEMORY:
        errno = ENOMEM;
        break;
    case ERROR_DISK_FULL:
        errno = ENOSPC;
        break;
    default:
        errno = EIO;
    }
    return 0;
}

/* A path for the system: memory to free, or null. */
static wchar_t *wide(const char *path)
{
    int n = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, NULL, 0);
    wchar_t *w = n > 0 ? malloc((size_t)n * sizeof *w) : NULL;

    if (w)
        MultiByteToWideChar(CP_UTF8, 0, path, -1, w, n);
    else
        errno = n > 0 ? ENOMEM : ENOENT;
    return w;
}

static char *narrow(const wchar_t *w)
{
    int n = WideCharToMultiByte(CP_UTF8, 0, w, -1, NULL, 0, NULL, NULL);
    char *path = malloc((size_t)n + 1);

    if (path)
        WideCharToMultiByte(CP_UTF8, 0, w, -1, path, n, NULL, NULL);
    return path;
}

static HANDLE handle_of(FILE *stream)
{
    return (HANDLE)_get_osfhandle(_fileno(stream));
}

/* ------------------------------------------------------------------------------------------------ begin */

/* Not declared in any header: the arguments of the program, with * and ? expanded. */
typedef struct start_info {
    int new_mode;
} start_info;
extern int __cdecl __wgetmainargs(int *, wchar_t ***, wchar_t ***, int, start_info *);

static void restore_page(void)
{
    SetConsoleOutputCP(old_page);
}

static void end(int number)
{
    if (at_work)
        DeleteFileW(at_work);
    signal(number, SIG_DFL);
    raise(number);
}

void system_begin(int *argc, char ***argv)
{
    start_info info = {0};
    wchar_t **given, **environment;
    char **list;
    int n, i;

    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
    old_page = GetConsoleOutputCP();
    if (old_page && SetConsoleOutputCP(CP_UTF8))
        atexit(restore_page);
    signal(SIGINT, end);
    signal(SIGTERM, end);
    signal(SIGBREAK, end);
    if (__wgetmainargs(&n, &given, &environment, 1, &info) < 0)
        return;
    list = calloc((size_t)n + 1, sizeof *list); /* kept until the program ends */
    for (i = 0; list && i < n; i++)
        if ((list[i] = narrow(given[i])) == NULL)
            return;
    if (list) {
        *argc = n;
        *argv = list;
    }
}

/* ------------------------------------------------------------------------------------------------ names */

int system_is_separator(char c)
{
    return c == '/' || c == '\\' || c == ':';
}

int system_is_absolute(const char *path)
{
    return path[0] && (system_is_separator(path[0]) || path[1] == ':');
}

int system_read_link(const char *path, char *target, size_t size)
{
    (void)path; /* links are rare here; such a path names the link itself */
    (void)target;
    (void)size;
    return 0;
}

/* ------------------------------------------------------------------------------------------------ files */

/* Open a file or folder only for queries; INVALID_HANDLE_VALUE with errno set on failure. */
static HANDLE open_place(const char *path)
{
    wchar_t *w = wide(path);
    HANDLE handle = INVALID_HANDLE_VALUE;

    if (!w)
        return handle;
    handle = CreateFileW(w, 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, NULL,
                         OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL);
    if (handle == INVALID_HANDLE_VALUE)
        fail();
    free(w);
    return handle;
}

system_kind system_kind_of(const char *path)
{
    HANDLE handle = open_place(path);
    BY_HANDLE_FILE_INFORMATION info;
    system_kind kind = SYSTEM_OTHER;

    if (handle == INVALID_HANDLE_VALUE)
        return errno == ENOENT ? SYSTEM_NOTHING : SYSTEM_ERROR;
    if (GetFileType(handle) == FILE_TYPE_DISK && GetFileInformationByHandle(handle, &info))
        kind = info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY ? SYSTEM_FOLDER : SYSTEM_FILE;
    CloseHandle(handle);
    return kind;
}

static int is_same(HANDLE x, HANDLE y)
{
    BY_HANDLE_FILE_INFORMATION a, b;

    return GetFileType(x) == FILE_TYPE_DISK && GetFileType(y) == FILE_TYPE_DISK &&
           GetFileInformationByHandle(x, &a) && GetFileInformationByHandle(y, &b) &&
           a.dwVolumeSerialNumber == b.dwVolumeSerialNumber &&
           a.nFileIndexHigh == b.nFileIndexHigh && a.nFileIndexLow == b.nFileIndexLow;
}

int system_is_same(const char *x, const char *y)
{
    HANDLE a = open_place(x), b = open_place(y);
    int same = a != INVALID_HANDLE_VALUE && b != INVALID_HANDLE_VALUE && is_same(a, b);

    if (a != INVALID_HANDLE_VALUE)
        CloseHandle(a);
    if (b != INVALID_HANDLE_VALUE)
        CloseHandle(b);
    return same;
}

int system_is_open_as(const char *path, FILE *stream)
{
    HANDLE place = open_place(path);
    int same = place != INVALID_HANDLE_VALUE && is_same(place, handle_of(stream));

    if (place != INVALID_HANDLE_VALUE)
        CloseHandle(place);
    return same;
}

int system_may_write(const char *path)
{
    wchar_t *w = wide(path);
    DWORD attributes = w ? GetFileAttributesW(w) : INVALID_FILE_ATTRIBUTES;

    free(w);
    if (attributes == INVALID_FILE_ATTRIBUTES || !(attributes & FILE_ATTRIBUTE_READONLY))
        return 1; /* opening the file will report the error */
    errno = EACCES;
    return 0;
}

int system_make_folder(const char *path)
{
    wchar_t *w = wide(path);
    int is_made = w && CreateDirectoryW(w, NULL);

    if (w && !is_made)
        fail();
    free(w);
    if (is_made || system_kind_of(path) == SYSTEM_FOLDER)
        return 1;
    errno = system_kind_of(path) == SYSTEM_FILE ? ENOTDIR : errno;
    return 0;
}

int system_list(const char *folder, int (*take)(void *host, const char *name), void *host)
{
    WIN32_FIND_DATAW entry;
    char *pattern = malloc(strlen(folder) + sizeof "/*");
    wchar_t *w = pattern ? wide(strcat(strcpy(pattern, folder), "/*")) : NULL;
    HANDLE names = w ? FindFirstFileW(w, &entry) : INVALID_HANDLE_VALUE;
    int is_wanted = 1;

    if (w && names == INVALID_HANDLE_VALUE)
        fail();
    free(pattern);
    free(w);
    if (names == INVALID_HANDLE_VALUE)
        return 0;
    do {
        char *name = narrow(entry.cFileName);

        is_wanted = name && take(host, name);
        free(name);
    } while (is_wanted && FindNextFileW(names, &entry));
    FindClose(names);
    return is_wanted;
}

FILE *system_open(const char *path, const char *mode)
{
    wchar_t *w = wide(path), *m = wide(mode);
    FILE *file = w && m ? _wfopen(w, m) : NULL;

    free(w);
    free(m);
    return file;
}

FILE *system_open_regular(const char *path)
{
    system_kind kind = system_kind_of(path);

    if (kind == SYSTEM_FOLDER || kind == SYSTEM_OTHER)
        errno = 0;
    return kind == SYSTEM_FILE ? system_open(path, "rb") : NULL;
}

/* The path of an open handle, in the system's own form: memory to free, or null. */
static wchar_t *real_path(HANDLE handle)
{
    DWORD n = GetFinalPathNameByHandleW(handle, NULL, 0, 0);
    wchar_t *path = n > 0 ? malloc((n + 2) * sizeof *path) : NULL;

    if (path && GetFinalPathNameByHandleW(handle, path, n + 1, 0) == 0)
        path[0] = L'\0';
    return path;
}

int system_is_within(const char *folder, const char *path)
{
    HANDLE place = open_place(folder), file = open_place(path);
    wchar_t *x = place != INVALID_HANDLE_VALUE ? real_path(place) : NULL,
            *y = file != INVALID_HANDLE_VALUE ? real_path(file) : NULL;
    size_t n = x ? wcslen(x) : 0;
    int is_within;

    if (n && x[n - 1] == L'\\')
        n--;
    is_within =
        n && (file == INVALID_HANDLE_VALUE || (y && wcsncmp(x, y, n) == 0 && y[n] == L'\\'));
    free(x);
    free(y);
    if (place != INVALID_HANDLE_VALUE)
        CloseHandle(place);
    if (file != INVALID_HANDLE_VALUE)
        CloseHandle(file);
    errno =
        (place != INVALID_HANDLE_VALUE && !x) || (file != INVALID_HANDLE_VALUE && !y) ? ENOMEM : 0;
    return is_within;
}

/* A new file, which can be removed while it is open; null with errno set. */
static FILE *create(const wchar_t *name, DWORD flags)
{
    HANDLE handle = CreateFileW(name, GENERIC_READ | GENERIC_WRITE | DELETE,
                                FILE_SHARE_READ | FILE_SHARE_DELETE, NULL, CREATE_NEW,
                                FILE_ATTRIBUTE_NORMAL | flags, NULL);
    int descriptor;

    if (handle == INVALID_HANDLE_VALUE) {
        fail();
        return NULL;
    }
    descriptor = _open_osfhandle((intptr_t)handle, _O_BINARY);
    return descriptor < 0 ? NULL : _fdopen(descriptor, "w+b");
}

/* The same with a unique name: XXXXXX at its end is replaced. */
static FILE *create_new(wchar_t *name, DWORD flags)
{
    wchar_t *letters = name + wcslen(name) - 6;
    unsigned long k = GetCurrentProcessId();
    int attempt, i;

    for (attempt = 0; attempt < 1000; attempt++) {
        unsigned long rest = k = k * 69069UL + GetTickCount();
        FILE *file;

        for (i = 0; i < 6; i++, rest /= 26)
            letters[i] = (wchar_t)(L'a' + rest % 26);
        file = create(name, flags);
        if (file || GetLastError() != ERROR_FILE_EXISTS)
            return file;
    }
    return NULL;
}

FILE *system_scratch(void)
{
    wchar_t name[MAX_PATH + 20];
    DWORD n = GetTempPathW(MAX_PATH + 1, name);

    if (n == 0 || n > MAX_PATH) {
        errno = ENOENT;
        return NULL;
    }
    wcscat(name, L"fourlinkXXXXXX");
    return create_new(name, FILE_FLAG_DELETE_ON_CLOSE | FILE_ATTRIBUTE_TEMPORARY);
}

FILE *system_create(char *name, const char *like)
{
    wchar_t *temporary = wide(name), *letters;
    FILE *file = temporary ? create_new(temporary, 0) : NULL;
    size_t end = strlen(name), i;

    (void)like; /* a new file inherits the permissions of its folder */
    if (!file) {
        free(temporary);
        return NULL;
    }
    letters = temporary + wcslen(temporary) - 6;
    for (i = 0; i < 6; i++)
        name[end - 6 + i] = (char)letters[i];
    at_work = temporary;
    return file;
}

static void forget(void)
{
    wchar_t *w = at_work;

    at_work = NULL;
    free(w);
}

int system_rename(const char *name, const char *path)
{
    wchar_t *from = wide(name), *to = wide(path);
    int done = from && to && (MoveFileExW(from, to, MOVEFILE_REPLACE_EXISTING) || fail());

    free(from);
    free(to);
    if (done)
        forget();
    return done;
}

void system_remove(const char *name)
{
    wchar_t *w = wide(name);

    if (w)
        DeleteFileW(w);
    free(w);
    forget();
}

void system_watch(char *name)
{
    forget();
    at_work = wide(name);
}

/* -------------------------------------------------------------------------------------------- terminals */

int system_is_terminal(FILE *stream)
{
    DWORD mode;

    return GetConsoleMode(handle_of(stream), &mode) != 0;
}

unsigned long system_width(FILE *stream)
{
    CONSOLE_SCREEN_BUFFER_INFO info;

    if (!GetConsoleScreenBufferInfo(handle_of(stream), &info))
        return 0;
    return (unsigned long)(info.srWindow.Right - info.srWindow.Left + 1);
}

/* ---------------------------------------------------------------------------------------------- signals */

static void on_signal(int number)
{
    caught = number;
    signal(number, on_signal);
}

void system_catch(int begin)
{
    if (begin)
        caught = 0;
    signal(SIGINT, begin ? on_signal : end);
    signal(SIGTERM, begin ? on_signal : end);
    signal(SIGBREAK, begin ? on_signal : end);
}

int system_caught(void)
{
    return (int)caught;
}

/* --------------------------------------------------------------------------------------------- programs */

/* The arguments in one line.  None of ours has blanks or quotes. */
static wchar_t *command_line(const char *const *arguments)
{
    char line[LONGEST_COMMAND] = "";

    for (; *arguments && strlen(line) + strlen(*arguments) + 2 < sizeof line; arguments++) {
        strcat(line, line[0] ? " " : "");
        strcat(line, *arguments);
    }
    return wide(line);
}

/* A handle that a child process inherits; null with errno set on failure. */
static HANDLE inherited(HANDLE handle)
{
    HANDLE self = GetCurrentProcess(), copy;

    if (DuplicateHandle(self, handle, self, &copy, 0, TRUE, DUPLICATE_SAME_ACCESS))
        return copy;
    fail();
    return NULL;
}

/* A job whose processes end with this one. */
static HANDLE common_end(void)
{
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits;
    HANDLE job = CreateJobObjectW(NULL, NULL);

    memset(&limits, 0, sizeof limits);
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    if (job)
        SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
    return job;
}

/* Start a program from PATH.  The working folder is not searched: it may hold someone else's files. */
static int start_program(const char *const *arguments, HANDLE standard[3], HANDLE job,
                         HANDLE *process)
{
    wchar_t *line = command_line(arguments), *name = wide(arguments[0]), program[MAX_PATH];
    const wchar_t *path = _wgetenv(L"PATH");
    PROCESS_INFORMATION child;
    STARTUPINFOW how;
    int done;

    memset(&how, 0, sizeof how);
    how.cb = sizeof how;
    how.dwFlags = STARTF_USESTDHANDLES;
    how.hStdInput = standard[0];
    how.hStdOutput = standard[1];
    how.hStdError = standard[2];
    done =
        line && name && path && SearchPathW(path, name, L".exe", MAX_PATH, program, NULL) &&
        CreateProcessW(program, line, NULL, NULL, TRUE, CREATE_SUSPENDED, NULL, NULL, &how, &child);
    if (done) {
        if (job)
            AssignProcessToJobObject(job, child.hProcess);
        ResumeThread(child.hThread);
        CloseHandle(child.hThread);
        *process = child.hProcess;
    } else if (line && name) {
        fail();
        if (!path)
            errno = ENOENT;
    }
    free(line);
    free(name);
    return done;
}

/* Copy a stream.  Returns the number of bytes, or -1 with errno set if they cannot be written. */
static long copy(HANDLE from, FILE *to)
{
    long copied = 0;
    char part[8192];
    DWORD n;

    while (ReadFile(from, part, sizeof part, &n, NULL) && n > 0) {
        if (fwrite(part, 1, n, to) != n)
            return -1;
        copied += (long)n;
    }
    return copied;
}

void system_forget(const char *variable)
{
    SetEnvironmentVariableA(variable, NULL);
}

int system_run(const char *const *arguments, FILE *input, FILE *output, FILE *complaints,
               system_outcome *outcome)
{
    HANDLE standard[3] = {NULL, NULL, NULL}, from = NULL, to = NULL, process = NULL, job;
    DWORD status = 0;
    int done, i;

    memset(outcome, 0, sizeof *outcome);
    if (fflush(input) != 0 || fseek(input, 0, SEEK_SET) != 0)
        return 0;
    if (!CreatePipe(&from, &to, NULL, 0))
        return fail();
    standard[0] = inherited(handle_of(input));
    standard[1] = inherited(to);
    standard[2] = inherited(handle_of(complaints));
    CloseHandle(to);
    job = common_end();
    done = standard[0] && standard[1] && standard[2] &&
           start_program(arguments, standard, job, &process);
    for (i = 0; i < 3; i++)
        if (standard[i])
            CloseHandle(standard[i]);
    outcome->is_found = done || errno != ENOENT;
    if (done) {
        outcome->copied = copy(from, output);
        done = outcome->copied >= 0;
        CloseHandle(from);
        WaitForSingleObject(process, INFINITE);
        GetExitCodeProcess(process, &status);
        CloseHandle(process);
        outcome->status = (int)status;
    } else {
        CloseHandle(from);
        done = !outcome->is_found;
    }
    if (job)
        CloseHandle(job);
    return done;
}

#endif
